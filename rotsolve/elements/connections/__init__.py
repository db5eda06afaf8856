"""Connections: what touches what. Each states facts (forces, rate rules); no law is written here."""

from rotsolve.elements.connections.connection import Connection as Connection
from rotsolve.elements.connections.contacts.contact import Contact
from rotsolve.elements.connections.contacts.friction import Friction
from rotsolve.elements.connections.contacts.rolling import Rolls, Unrolls
from rotsolve.elements.connections.contacts.rubbing import Clutch
from rotsolve.elements.connections.drives import Belt, Drive, Gear
from rotsolve.elements.connections.guides import guide as guide
from rotsolve.elements.connections.ropes.drapes import Drapes
from rotsolve.elements.connections.ropes.strings import String
from rotsolve.elements.connections.shafts import Shaft
from rotsolve.elements.connections.springs import Spring, Torsion
from rotsolve.elements.connections.supports import Axle, Ball, Clamp, Hinge, Rides, Weld

CONNECTIONS: tuple[type[Connection], ...] = (
    Hinge,
    Axle,
    Shaft,
    Ball,
    Clamp,
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
    Drive,
    Clutch,
    Rides,
)

__all__ = ["CONNECTIONS", "Connection", "Contact", "Friction", "Hinge", "Rides", "String", "Weld", "guide"]
