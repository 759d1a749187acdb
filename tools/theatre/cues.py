# SPDX-License-Identifier: Apache-2.0
"""Thirteen lamps, and five cues of four seconds. Every lamp is a function of the cue and of the seconds in it."""
from festival.channels import Look
from festival.choreography import WHITE, aimed
from festival.layout import BELOW_TRUSS, Fixture, Line

from . import stage

CUE_S = 4.0
CUES = ("moonlight", "monologue", "day", "forest", "sunset")
BLUE, WARM, GREEN, ORANGE = (0.03, 0.12, 1.0), (1.0, 0.72, 0.42), (0.1, 0.9, 0.2), (1.0, 0.33, 0.04)


def hang():
    """The front, the specials over the stage, the back light; the row that stands on the floor and lights the cyclorama."""
    made = []
    high = stage.GRID_Z - BELOW_TRUSS
    for role, kind, y, xs in (("front", "Wash", -4.0, (-4.5, -1.5, 1.5, 4.5)), ("special", "Spot", 0.6, (-3.0, 0.0, 3.0)),
                              ("back", "Wash", 5.4, (-3.0, 3.0)), ("row", "Wash", 5.8, (-4.8, -1.6, 1.6, 4.8))):
        standing = role == "row"
        line = Line(role, 1.0, [], standing)
        for index, x in enumerate(xs):
            made.append(Fixture(f"{role.capitalize()} {index + 1}", kind, line, (x, y, 0.0 if standing else high), index, len(xs)))
    used = 0
    for fixture in made:
        fixture.universe, fixture.address = 1, used + 1
        used += fixture.channels
    return made


class Cues:
    def at(self, t):
        """(cue, seconds in it)."""
        number = min(len(CUES) - 1, int((t + 1e-9) / CUE_S))
        return CUES[number], t - number * CUE_S

    def look(self, fixture, cue, t):
        return getattr(self, fixture.role)(fixture, cue, t)

    def front(self, f, cue, t):
        level, colour = {"day": (0.6, WARM), "sunset": (0.35 if f.index < 2 else 0.0, ORANGE)}.get(cue, (0.0, WHITE))
        x = f.position[0]
        return Look(*aimed(f, (0.55 * x, 2.4, 1.2)), level, colour, width=0.5)

    def special(self, f, cue, t):
        if cue == "monologue" and f.index == 1:   # one narrow warm beam on one actor
            return Look(*aimed(f, (0.9, 1.8, 1.3)), 0.8, WARM, iris=0.35)
        if cue == "forest":   # leaves on the floor that turn slowly
            return Look(*aimed(f, (f.position[0] * 0.8, 3.0, 0.0)), 0.9, GREEN, width=0.7, gobo="leaves", rotating="foliage",
                        turns_per_s=0.05 * (f.index - 1), focus_m=7)
        return Look(0.0, -90.0, 0.0, WHITE)

    def back(self, f, cue, t):
        level, colour = {"moonlight": (0.25, (0.5, 0.65, 1.0)), "sunset": (0.5, ORANGE), "day": (0.2, WHITE)}.get(cue, (0.0, WHITE))
        return Look(*aimed(f, (0.4 * f.position[0], 2.2, 0.8)), level, colour, width=0.4)

    def row(self, f, cue, t):
        level, colour = {"moonlight": (0.6, BLUE), "day": (0.9, WHITE), "forest": (0.25, GREEN), "sunset": (0.8, ORANGE)}.get(cue, (0.0, WHITE))
        return Look(*aimed(f, (f.position[0], stage.CYC_Y, 3.4)), level, colour, width=1.0)
