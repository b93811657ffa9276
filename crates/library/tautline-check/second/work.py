"""How much a checker does for a file, and how much of it at a time."""

from refused import require


class Work:
    """What is left of a budget of units of work, as `../FORMAT.md` counts them."""

    def __init__(self, budget):
        self.budget, self.spent = budget, 0

    def spend(self, units):
        self.spent += units
        too_much = f"the check needs more than {self.budget} units of work, the most for this size"
        require(self.spent <= self.budget, too_much)


UNLIMITED = Work(float("inf"))


def batches(count, size):
    """Slices of at most so many of the numbers from 0."""
    return [slice(start, start + size) for start in range(0, count, size)]
