"""`python -m rotsolve`: the same as the command `rotsolve`."""

from rotsolve.start import process

if __name__ == "__main__":
    process()
