# SPDX-License-Identifier: Apache-2.0
"""Pictures for tests, as rows of pixels."""
from lib import needs

needs.packages("python3-pil")
from PIL import Image  # noqa: E402


def read(path):
    """Width, height and rows of (R, G, B)."""
    with Image.open(path) as picture:
        width, height = picture.size
        pixels = list(picture.convert("RGB").getdata())
    return width, height, [pixels[y * width:(y + 1) * width] for y in range(height)]


def write(path, width, height, colour):
    """colour: of (x, y), as (R, G, B)."""
    picture = Image.new("RGB", (width, height))
    picture.putdata([tuple(colour(x, y)) for y in range(height) for x in range(width)])
    picture.save(path)
