"""Connections: what touches what. Each states facts (forces, rate rules); no law is written here."""

from rotsolve.elements.connections.contact import Contact, Rolls, Unrolls
from rotsolve.elements.connections.drapes import Drapes
from rotsolve.elements.connections.drives import Belt, Gear, MutualDrive
from rotsolve.elements.connections.drives import guide as guide
from rotsolve.elements.connections.pairs import Ball, Clamp, Collar, Screw, Sleeve, Slide, Universal
from rotsolve.elements.connections.rubbing import Clutch
from rotsolve.elements.connections.slots import PinSlot
from rotsolve.elements.connections.springs import Spring, Torsion
from rotsolve.elements.connections.strings import String
from rotsolve.elements.connections.supports import Axle, Hinge, Rides, Shaft, Weld
from rotsolve.elements.connections.touch import Friction as Friction
from rotsolve.language.elements import Connection as Connection

CONNECTIONS: list[type[Connection]] = [
    Hinge,
    Axle,
    Shaft,
    Ball,
    Collar,
    Clamp,
    Slide,
    Sleeve,
    Screw,
    Universal,
    Weld,
    Contact,
    Rolls,
    Unrolls,
    String,
    Drapes,
    Spring,
    Torsion,
    Belt,
    Gear,
    MutualDrive,
    Clutch,
    Rides,
    PinSlot,
]
