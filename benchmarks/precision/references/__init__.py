"""References of 60 digits: each by two routes that share no more than the numbers of the problem."""
