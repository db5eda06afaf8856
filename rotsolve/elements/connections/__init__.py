"""Connections: what touches what. Each states facts (forces, rate rules); no law is written here."""
