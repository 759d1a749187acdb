# SPDX-License-Identifier: Apache-2.0
"""Where everything stands and hangs, and the patch. Metres, seen from the house: X right, Y up-stage, Z up."""
from demo_show.rig import HEAD_BELOW_M

DECK_Z, DECK_HALF_WIDTH, DECK_DEPTH = 1.8, 12.0, 14.0
EAVES_Z, RIDGE_Z, LEG_X = 13.4, 16.4, 13.4
WALL_HALF_WIDTH, WALL_LOW, WALL_HIGH, WALL_Y = 7.0, 2.6, 7.6, 12.9   # the LED wall
WING_INNER, WING_OUTER, WING_Z = 14.6, 20.4, 9.6                    # trusses of the wings that carry the sound
DELAY_TOWERS = ((-16.0, -44.0), (16.0, -44.0))
DELAY_Z = 8.2
BELOW_TRUSS = 0.26    # from the middle of a truss to the top of a fixture's base
MOST_IN_LINE = 98     # numbers within a hundred; even, for two sides
PITCH = 0.53          # a base is 0.494 m long
MODES = {"Spot": ("Vari-Lite@VL2500_Spot.gdtf", "Standard 22 channels", 22),
         "Wash": ("Vari-Lite@VL2500_Wash.gdtf", "Standard 15 channels", 15)}


class Line:
    """Fixtures side by side. role says what they are there for; several spans are pairs, left and right."""

    def __init__(self, role, weight, spans, standing=False, rows=1, depth=0.0, pattern="SSW"):
        self.role, self.weight, self.spans = role, weight, spans   # spans: [(from, to)], points
        self.standing, self.rows, self.depth, self.pattern = standing, rows, depth, pattern

    def room(self):
        return self.rows * sum(self.room_of(span) for span in self.spans)

    @staticmethod
    def room_of(span):
        return int(sum((b - a) ** 2 for a, b in zip(*span)) ** 0.5 / PITCH) + 1

    def places(self, count):
        """count positions, the spans and rows sharing them as evenly as goes."""
        parts = [(span, row) for row in range(self.rows) for span in self.spans]   # sides take turns
        shares = shared(count, [1.0] * len(parts), [self.room_of(span) for span, _ in parts])
        found = []
        for (span, row), number in zip(parts, shares):
            for i in range(number):
                k = 0.5 if number == 1 else i / (number - 1)
                x, y, z = (a + (b - a) * k for a, b in zip(*span))
                found.append((x, y + 0.44 * (row - (self.rows - 1) / 2), z))
        mirrored = (lambda p: 1 if p[0] < 0 else -1)   # the place as far from the other end is the one opposite
        return sorted(found, key=lambda p: (round(p[0], 4), mirrored(p) * p[2], mirrored(p) * p[1]))


class Fixture:
    """One lamp. across: -1 left .. 1 right, depth: 0 front .. 1 back, index along its line."""

    def __init__(self, name, kind, line, position, index, count):
        self.name, self.kind, self.role, self.standing = name, kind, line.role, line.standing
        self.position = tuple(round(c, 3) for c in position)
        self.across = max(-1.0, min(1.0, self.position[0] / DECK_HALF_WIDTH))
        self.side = -1 if self.position[0] < -1e-6 else 1
        self.depth, self.index = line.depth, index
        self.from_middle = min(index, count - 1 - index)
        self.gdtf, self.mode, self.channels = MODES[kind]
        self.universe = self.address = 0

    def pivot(self):
        x, y, z = self.position
        return x, y, z + (HEAD_BELOW_M if self.standing else -HEAD_BELOW_M)


def shared(total, weights, rooms):
    """Whole numbers that add up to total (or to all room there is), near the weights, none above its room."""
    shares = [0] * len(weights)
    for _ in range(min(total, sum(rooms))):
        open_ones = [i for i in range(len(weights)) if shares[i] < rooms[i]]
        i = min(open_ones, key=lambda j: ((shares[j] + 0.5) / weights[j], j))
        shares[i] += 1
    return shares


def trusses(fixtures):
    """[(y, z, upper)]: the truss lines over the deck, front to back; the back hangs lower, so that all rows are seen."""
    count = next(lines for most, lines in ((23, 3), (90, 4), (200, 5), (450, 6), (800, 8), (1200, 10), (1 << 30, 12))
                 if fixtures <= most)
    lower = [(0.5 + 10.9 * i / (count - 1), 11.3 - 2.9 * i / (count - 1) + (0.35 if i % 2 else 0.0), False) for i in range(count)]
    upper = [(1.0 + 11.0 * i / 7, 12.7, True) for i in range(8)] if fixtures > 1200 else []
    return lower + upper


def lines(fixtures):
    found = []
    rows = 2 if fixtures > 800 else 1
    for number, (y, z, upper) in enumerate(trusses(fixtures)):
        front = number == 0
        span = ((-11.6, y, z - BELOW_TRUSS), (11.6, y, z - BELOW_TRUSS))
        found.append(Line("front" if front else "truss", 1.0 if front else 0.7 if upper else 1.25, [span], rows=rows, depth=y / DECK_DEPTH,
                          pattern="WSS" if front else "SSW"))
    deck = DECK_Z
    found.append(Line("floor", 1.3, [((-11.3, 12.1, deck), (11.3, 12.1, deck))], True, rows, 0.86, "S"))
    if fixtures >= 24:
        found.append(Line("tower", 0.9, [((s * 12.55, y, 3.4), (s * 12.55, y, 9.4)) for y in (3.0, 10.0) for s in (-1, 1)], depth=0.5,
                          pattern="SSW"))
        found.append(Line("floor", 0.7, [((s * 5.4, 0.6, deck), (s * 11.5, 0.6, deck)) for s in (-1, 1)], True, depth=0.04, pattern="S"))
    if fixtures >= 50:
        top = WALL_HIGH + 0.75 - BELOW_TRUSS
        found.append(Line("truss", 0.6, [((-WALL_HALF_WIDTH, 12.5, top), (WALL_HALF_WIDTH, 12.5, top))], depth=0.9, pattern="SSW"))
    if fixtures >= 100:
        z = WING_Z - BELOW_TRUSS
        found.append(Line("wing", 0.9, [((s * WING_INNER, 0.6, z), (s * WING_OUTER, 0.6, z)) for s in (-1, 1)], rows=rows, depth=0.05,
                          pattern="S"))
        found.append(Line("floor", 0.6, [((s * 6.8, 8.6, deck), (s * 11.4, 8.6, deck)) for s in (-1, 1)], True, depth=0.6, pattern="SSW"))
    if fixtures >= 250:
        spans = [((x, y + 0.9, z), (x, y - 0.9, z)) for z in (DELAY_Z - 0.9, DELAY_Z - 2.4) for x, y in DELAY_TOWERS]
        found.append(Line("delay", 0.3, spans, pattern="S"))
        found.append(Line("floor", 0.7, [((-13.0, -1.1, 0.0), (13.0, -1.1, 0.0))], True, depth=0.0, pattern="S"))
    if fixtures >= 700:
        sides = [((s * x, 12.4, 2.9), (s * x, 12.4, 8.2)) for x in (7.9, 9.2, 10.5) for s in (-1, 1)]
        found.append(Line("tower", 1.0, sides, depth=0.9, pattern="SSW"))
    return found


def hang(fixtures):
    """The fixtures, named and patched, line by line. A number is its line's hundred and its place in it."""
    every = lines(fixtures)
    rooms = [min(MOST_IN_LINE, line.room()) for line in every]
    counts = shared(fixtures, [line.weight for line in every], rooms)
    for i, line in enumerate(every):   # both sides alike: the odd one goes to the second truss
        if len(line.spans) > 1 and counts[i] % 2 and counts[1] < rooms[1]:
            counts[i] -= 1
            counts[1] += 1
    made = []
    for number, (line, count) in enumerate(zip(every, counts), 1):
        for i, place in enumerate(line.places(count)):
            kind = "Spot" if line.pattern[min(i, count - 1 - i) % len(line.pattern)] == "S" else "Wash"
            made.append(Fixture(f"{kind} {100 * number + i + 1}", kind, line, place, i, count))
    universe, used = 1, 0
    for fixture in made:
        if used + fixture.channels > 512:
            universe, used = universe + 1, 0
        fixture.universe, fixture.address = universe, used + 1
        used += fixture.channels
    return made
