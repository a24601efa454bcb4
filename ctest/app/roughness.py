"""Forces of what slides over a rough surface, as they are and as they should be (docs/method/play.md)."""
import numpy


def level(force, rate, low, high):
    """Root of the mean square of a force in a band of frequencies, N."""
    window = numpy.hanning(len(force))
    power = 2 * abs(numpy.fft.rfft(force * window)) ** 2 / (len(force) * (window ** 2).sum())
    frequency = numpy.fft.rfftfreq(len(force), 1 / rate)
    return numpy.sqrt(power[(frequency >= low) & (frequency < high)].sum())


def expected_level(tool, speed, low, high):
    """The same by the waves of the roughness, each through the contact.

    :param tool: mass (kg), hardness (N/m^(3/2)), load (N), size (m) and height (m) of the roughness, whose waves have an exponent
        and are from the longest to the shortest (m)
    """
    rough, length = tool["roughness"], 100 * tool["roughness"]["longest"]
    n = numpy.arange(100, length / rough["shortest"] + 1)
    power = n ** -float(rough["exponent"])
    power *= tool["height"] ** 2 / power.sum()
    angular = 2 * numpy.pi * n * speed / length
    spring = 1.5 * tool["hardness"] * (tool["load"] / tool["hardness"]) ** (1 / 3)
    s = 1j * angular / numpy.sqrt(spring / tool["mass"])
    felt = numpy.exp(-((angular / speed * tool["size"]) ** 2) / 8)
    force = power * (felt * spring * abs(s * s / (s * s + 0.2 * s + 1))) ** 2
    return numpy.sqrt(force[(angular >= 2 * numpy.pi * low) & (angular < 2 * numpy.pi * high)].sum())
