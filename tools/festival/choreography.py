# SPDX-License-Identifier: Apache-2.0
"""What the rig does: 120 beats a minute, seven acts of 30 seconds in all, then again in other colours.

A head's direction is (turn, rise) in degrees: turn 0 looks at the house and +90 to the right, rise 0 is level and 90 straight up. Rise may
run past the vertical, so that a sweep over the head does not make the yoke jump.
"""
import math

from .channels import Look

BEAT_S = 0.5
CROSSFADE_S = 0.8
BLACK_AFTER_S = 1.65   # of the build
# complementary pairs, then an accent; linear red, green, blue
PALETTES = [((0.0, 0.22, 1.0), (1.0, 0.42, 0.02), (0.55, 0.9, 1.0)), ((1.0, 0.0, 0.5), (0.0, 1.0, 0.45), (1.0, 0.75, 0.85)),
            ((0.0, 0.85, 1.0), (1.0, 0.08, 0.03), (1.0, 0.85, 0.6)), ((0.42, 0.0, 1.0), (1.0, 0.85, 0.0), (0.9, 0.75, 1.0))]
WHITE = (1.0, 1.0, 1.0)
BAND = [(0.1, 2.9, 3.3), (-2.9, 3.1, 3.2), (2.9, 3.1, 3.2), (0.0, 9.2, 4.3), (-4.6, 8.3, 4.1), (4.2, 8.4, 4.1), (0.1, 2.9, 3.3)]


def wave(x):
    """Sine of whole turns."""
    return math.sin(2 * math.pi * x)


def smooth(x):
    x = min(1.0, max(0.0, x))
    return x * x * (3 - 2 * x)


def mixed(a, b, k):
    return tuple(p + (q - p) * k for p, q in zip(a, b))


def aimed(fixture, target):
    """(turn, rise) towards a point; what lies up-stage is reached over the head, not by turning round."""
    x, y, z = (t - p for t, p in zip(target, fixture.pivot()))
    rise = math.degrees(math.atan2(z, math.hypot(x, y)))
    if y <= 0:
        return math.degrees(math.atan2(x, -y)), rise
    turn = math.degrees(math.atan2(-x, y))
    return turn, (180.0 if fixture.standing else -180.0) - rise


class Act:
    """One stretch of the show. Each act's look() is a function of the fixture and the seconds since its start."""
    seconds = 4.0

    def __init__(self, palette, spread):
        self.first, self.second, self.accent = palette
        self.spread = spread   # 0..1, how far neighbours' phases lie apart; from the seed

    def look(self, f, t):
        if f.role == "front" and f.kind == "Wash":
            return self.band_light(f, t)
        return getattr(self, f.role, self.truss)(f, t)

    def band_light(self, f, t):
        turn, rise = aimed(f, BAND[f.index % len(BAND)])
        return Look(turn, rise, 0.5, mixed(WHITE, (1.0, 0.72, 0.42), 0.6), width=0.3)

    def front(self, f, t):
        return self.truss(f, t)

    def wing(self, f, t):
        return self.truss(f, t)

    def delay(self, f, t):
        """Over the heads of the field, towards the stage and the sky."""
        look = self.truss(f, t)
        look.turn = -f.side * 12.0 + 14 * wave(t / 6 + 0.1 * f.from_middle)
        look.rise = -188.0 + 6 * wave(t / 5 + 0.13 * f.from_middle)
        look.level *= 0.6
        return look


class Dawn(Act):
    """Out of the dark: columns from the floor open from the middle to a fan, low washes."""

    def truss(self, f, t):
        if f.kind == "Wash":
            return Look(12 * wave(t / 9 + f.across), -68 + 10 * wave(t / 7 + f.depth), 0.5 * smooth(t / 2), self.first, width=0.5)
        on = smooth((t - 1.2 - 1.6 * abs(f.across)) / 0.8) * (f.from_middle % 3 == 0)
        return Look(f.across * 30, -52 - 10 * f.depth, 0.7 * on, self.accent, iris=0.2)

    def floor(self, f, t):
        angle = 46 * f.across * smooth((t - 0.6) / 3.2)
        return Look(90, 90 - angle, smooth((t - 1.6 * abs(f.across)) / 0.7), mixed(self.first, self.accent, 0.25), width=0.1, iris=0.16)

    def tower(self, f, t):
        return Look(-f.side * 40, 18 - 30 * smooth(t / 4), 0.4 * smooth((t - 2) / 1.5), self.second, width=0.1, iris=0.2)


class Fans(Act):
    """Fans that breathe, one row after the other, floor against truss in the complementary colour."""
    seconds = 6.0

    def truss(self, f, t):
        k = 0.5 - 0.5 * math.cos(2 * math.pi * (t / 4 - 0.35 * f.depth))
        rise = -15 + 22 * wave(t / 4 + 0.5 * f.depth + 0.18 * self.spread * abs(f.across))
        colour = mixed(self.first, self.accent, 0.35 * smooth(wave(t / 2 - abs(f.across))))
        if f.kind == "Wash":
            return Look(f.across * 35, -55 + 12 * wave(t / 4 + f.depth), 0.45, self.second, width=0.35)
        return Look(f.across * (18 + 52 * k), rise, 0.95, colour, iris=0.2)

    def floor(self, f, t):
        k = 0.5 + 0.5 * wave(t / 4)
        return Look(90, 90 - f.across * (12 + 50 * k), 0.9, self.second, width=0.15, iris=0.17)

    def tower(self, f, t):
        turn = -f.side * (32 + 22 * wave(t / 4 + 0.07 * f.from_middle))
        return Look(turn, -4 + 20 * wave(t / 3 + 0.11 * f.from_middle), 0.8, self.second, width=0.1, iris=0.2)


class Gobos(Act):
    """A break: wide turning gobos through the haze, every second lamp, thin columns between them."""

    def truss(self, f, t):
        if f.kind == "Wash":
            return Look(0, -70, 0.28, self.second, width=0.6)
        wide = f.from_middle % 2 == 0
        turn = f.across * 34 + 10 * wave(t / 8 + 0.5 * f.depth)
        if wide:
            gobo, rotating = (("rays", "vortex"), ("open", "window"), ("open", "rings"), ("bars", "vortex"))[f.from_middle // 2 % 4]
            return Look(turn, -34 - 14 * f.depth + 6 * wave(t / 6 + f.across), 1.0, self.first, width=0.55, gobo=gobo, rotating=rotating,
                        turns_per_s=0.22 * f.side, focus_m=14)
        return Look(turn * 1.6, 8 + 8 * wave(t / 5), 0.0, self.accent, iris=0.2)

    def floor(self, f, t):
        return Look(90, 90 - f.across * 24 - 8 * wave(t / 6), 0.75 if f.from_middle % 2 else 0.0, self.second, iris=0.12)

    def tower(self, f, t):
        return Look(-f.side * 52, -16 + 10 * wave(t / 6 + 0.1 * f.from_middle), 0.7, self.accent, width=0.35, gobo="dust", rotating="rings",
                    turns_per_s=-0.18 * f.side, focus_m=12)


class Crosses(Act):
    """Left and right answer each other and cross in the middle; rows chase on the beat."""

    def truss(self, f, t):
        swing = math.cos(2 * math.pi * t / 4)
        inner = f.from_middle % 2
        on = 1.0 if int(t / BEAT_S + 4 * f.depth) % 2 == inner else 0.16
        if f.kind == "Wash":
            return Look(-f.side * 30 * swing, -40, 0.6 * on, self.second, width=0.25)
        return Look(f.side * (8 + 38 * swing) + 20 * f.across, -6 - 12 * f.depth + 14 * wave(t / 4), on,
                    self.first if inner else self.accent, iris=0.22)

    def floor(self, f, t):
        swing = math.cos(2 * math.pi * t / 4 + 0.8 * f.across)
        return Look(90, 90 + f.side * 38 * swing, 0.9, self.second, iris=0.17)

    def tower(self, f, t):
        beat = int(t / (BEAT_S / 2)) % 4 == f.from_middle % 4
        return Look(-f.side * 58, 4 + 24 * wave(t / 4 + 0.05 * f.from_middle), 1.0 if beat else 0.12, self.first, width=0.1, iris=0.25)


class Build(Act):
    """Everything lifts from the floor into the sky while the strobe runs faster; then black."""
    seconds = 2.0

    def lit(self, turn, rise, k, t):
        level = 0.35 + 0.65 * k if t < BLACK_AFTER_S else 0.0
        return Look(turn, rise, level, mixed(self.first, WHITE, smooth(k)), width=0.2, iris=0.32, strobe_hz=3 + 13 * k)

    def truss(self, f, t):
        k = min(1.0, t / BLACK_AFTER_S)
        return self.lit(f.across * 28 * (1 + k), -82 + 108 * smooth(k), k, t)

    def floor(self, f, t):
        k = min(1.0, t / BLACK_AFTER_S)
        return self.lit(90, 90 - 60 * f.across * (1 - smooth(k)), k, t)

    def band_light(self, f, t):
        look = super().band_light(f, t)
        look.level = 0.0 if t >= BLACK_AFTER_S else look.level
        return look

    def delay(self, f, t):
        look = super().delay(f, t)
        look.strobe_hz = 0
        return look


class Drop(Act):
    """A white hit, then ballyhoo in waves of colour, with a strobe hit on every second bar."""
    seconds = 6.0

    def truss(self, f, t):
        phase = 0.5 * f.across * f.side + 0.37 * f.depth + self.spread * 0.09 * f.index
        hit = t % 4 < 0.36
        turn = f.across * 30 + 55 * f.side * wave(t / 2.4 + phase)
        rise = -2 + 27 * wave(t / 1.8 + 1.3 * phase)
        colour = mixed(self.first, self.second, smooth(0.5 + 0.9 * wave(t / 2 - 0.8 * abs(f.across) - 0.6 * f.depth)))
        if f.kind == "Wash":
            turn, rise = turn * 0.6, rise - 35
        if hit:
            return Look(turn, rise, 1.0, WHITE, width=0.3, iris=0.45, strobe_hz=14)
        if f.kind == "Wash":
            return Look(turn, rise, 0.45, self.first, width=0.1)
        return Look(turn, rise, 1.0, colour, iris=0.2)

    def floor(self, f, t):
        look = self.truss(f, t)
        look.turn, look.rise = 90, 90 + 50 * f.side * wave(t / 2 + 0.5 * abs(f.across) + 0.25 * f.depth)
        return look

    def tower(self, f, t):
        look = self.truss(f, t)
        look.turn, look.rise = -f.side * (45 + 30 * wave(t / 2 + 0.1 * f.from_middle)), 5 + 22 * wave(t / 1.5 + 0.08 * f.from_middle)
        return look


class Finale(Act):
    """One great fan over all rows, a wave of both colours, and the last light goes out from the sides to the middle."""

    def truss(self, f, t):
        out = 1 - smooth((t - 2.9 - 0.45 * (1 - abs(f.across))) / 0.4)
        colour = mixed(self.first, self.second, smooth(0.5 + 0.8 * wave(0.9 * f.across - t / 3)))
        if f.kind == "Wash":
            return Look(f.across * 50, -45, 0.35 * out, mixed(self.first, WHITE, 0.15), width=0.3)
        gobo = dict(rotating="vortex", turns_per_s=0.4 * f.side, width=0.3, iris=0.8) if f.from_middle % 4 == 3 else dict(iris=0.24)
        return Look(f.across * 62, 12 - 26 * f.depth + 10 * smooth(t / 3), out, colour, **gobo)

    def floor(self, f, t):
        out = 1 - smooth((t - 3.2 - 0.4 * (1 - abs(f.across))) / 0.3)
        return Look(90, 90 - f.across * 58 * smooth(0.3 + t / 2), out, mixed(self.second, self.accent, 0.3), iris=0.2)

    def tower(self, f, t):
        look = self.truss(f, t)
        look.turn, look.rise = -f.side * 36, 24 - 5.0 * (f.from_middle % 8)
        return look

    def band_light(self, f, t):
        look = super().band_light(f, t)
        look.level *= 1 - smooth((t - 3.4) / 0.4)
        return look


ACTS = (Dawn, Fans, Gobos, Crosses, Build, Drop, Finale)


class Show:
    def __init__(self, random):
        self.palettes = PALETTES[:]
        first = self.palettes.pop(0)
        random.shuffle(self.palettes)
        self.palettes.insert(0, first)
        self.spread = random.uniform(0.6, 1.0)
        self.round_s = sum(act.seconds for act in ACTS)
        self.made = {}

    def act(self, round_number, place):
        """The act and the look it leaves behind; colours change from act to act."""
        key = (round_number, place)
        if key not in self.made:
            self.made[key] = ACTS[place](self.palettes[(round_number * 3 + place // 2) % len(self.palettes)], self.spread)
        return self.made[key]

    def at(self, t):
        """(act, seconds into it, the act before or None)."""
        round_number, within = divmod(t + 1e-9, self.round_s)
        place = 0
        while place < len(ACTS) - 1 and within >= ACTS[place].seconds:
            within -= ACTS[place].seconds
            place += 1
        now = self.act(int(round_number), place)
        before = None
        if place or round_number:
            before = self.act(int(round_number), place - 1) if place else self.act(int(round_number) - 1, len(ACTS) - 1)
        return now, within, before

    def look(self, fixture, now, within, before):
        """Heads travel from where the act before left them; light and colour change at once."""
        look = now.look(fixture, within)
        if before and within < CROSSFADE_S:
            left = before.look(fixture, before.seconds)
            k = smooth(within / CROSSFADE_S)
            look.turn = left.turn + (look.turn - left.turn) * k
            look.rise = left.rise + (look.rise - left.rise) * k
        return look
