"""Texts and bytes with random damage."""

import re

NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w.])")
WORD = re.compile(r"[A-Za-z_]\w*")
NUMBERS = ("0", "-0.0", "1", "-1", "2", "0.5", "1e-320", "1e-300", "1e-30", "1e-10", "1e10", "1e30", "1e300", "1e308",
           "1e999", "-1e300", ".nan", ".inf", "-.inf", "nan", "inf", "2147483647", "2147483648", "4294967296",
           "9223372036854775807", "9223372036854775808", "-9223372036854775808", "0x7f", "1_000", "0.1.2", "1e", "--1")
VALUES = ("", "~", "[]", "{}", "[[]]", "[1, 2]", "[0, 0, 0]", "{a: 1}", "true", "no", "''", '"', "text", "*alias",
          "&anchor 1", "!!binary x", "!tag", "|", ">", "? key", "- 1", "<<: {}", "../..", "/", "/dev/zero", "/dev/null",
          "\u00e9\u4e2d", "\x00", "\x1b[31m", "%s%n%d", "{0}", "a" * 100000, "[" * 5000)
DIGITS = 12  # a number is multiplied by at most 10 to this power


def text(random, original, lines=()):
    """One to three changes of numbers, words, values, lines or bytes; lines are others that can be inserted."""
    changes = (number, number, number, word, value, line, lambda r, t: foreign_line(r, t, lines), characters)
    for _ in range(random.choice((1, 1, 2, 3))):
        original = random.choice(changes)(random, original)
    return original


def replaced(random, original, pattern, replacement):
    """With one match of the pattern replaced; replacement(found) gives the new text."""
    matches = list(pattern.finditer(original))
    if not matches:
        return original
    found = random.choice(matches)
    return original[:found.start()] + replacement(found[0]) + original[found.end():]


def number(random, original):
    def other(found):
        scaled = f"{float(found) * 10 ** random.uniform(-DIGITS, DIGITS):.6g}"
        return random.choice((random.choice(NUMBERS), scaled, f"-{found}", str(float(found) * random.uniform(0.5, 2))))
    return replaced(random, original, NUMBER, other)


def word(random, original):
    words = WORD.findall(original) or [""]
    return replaced(random, original, WORD, lambda found: random.choice((
        random.choice(words), found[:-1], found + random.choice("ab_1"), found.upper(), random.choice(VALUES))))


def value(random, original):
    """What follows a colon, a comma or an equals sign."""
    return replaced(random, original, re.compile(r"(?<=[:,=]) *[^,:{}\[\]\n]+"),
                    lambda found: " " + random.choice(VALUES + NUMBERS))


def line(random, original):
    rows = original.splitlines(keepends=True) or [""]
    here, there = (random.randrange(len(rows)) for _ in range(2))
    kind = random.randrange(5)
    if kind == 0:
        del rows[here]
    elif kind == 1:
        rows.insert(there, rows[here])
    elif kind == 2:
        rows[here], rows[there] = rows[there], rows[here]
    elif kind == 3:
        rows[here] = random.choice((" ", "  ", "\t", "- ")) + rows[here]
    else:
        del rows[here:]
    return "".join(rows)


def foreign_line(random, original, lines):
    rows = original.splitlines(keepends=True)
    rows.insert(random.randint(0, len(rows)), random.choice(lines) if lines else "\n")
    return "".join(rows)


def characters(random, original):
    return damaged(random, original.encode()).decode(errors="replace")


def damaged(random, data):
    """Bytes with bits flipped, bytes overwritten, a page zeroed, a piece cut out or repeated, or the end cut off."""
    data = bytearray(data)
    at = random.randrange(len(data)) if data else 0
    kind = random.choice(("bits", "bits", "bytes", "page", "cut", "repeat", "truncate"))
    length = random.choice((1, 8, 512, 4096))
    if kind == "bits":
        for _ in range(random.choice((1, 1, 1, 4, 32)) if data else 0):
            data[random.randrange(len(data))] ^= 1 << random.randrange(8)
    elif kind == "bytes":
        data[at:at + 8] = random.randbytes(len(data[at:at + 8]))
    elif kind == "page":
        data[at:at + length] = bytes(len(data[at:at + length]))
    elif kind == "cut":
        del data[at:at + length]
    elif kind == "repeat":
        data[at:at] = data[at:at + length]
    else:
        del data[at:]
    return bytes(data)
