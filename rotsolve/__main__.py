"""`python -m rotsolve`: the same as the command `rotsolve`."""

from rotsolve.start import main

if __name__ == "__main__":
    main()
