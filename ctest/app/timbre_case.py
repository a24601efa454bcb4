"""What the tests of timbre trees share: sounds of scenes, and what is known of them."""
import struct

import numpy
import scipy.io.wavfile

import program

INPUTS = program.SOURCE / "inputs/timbre"
RATE = 44100


class TimbreCase(program.TestCase):
    def timbre(self, scene, *arguments, status=program.FINISHED):
        """The samples [frames] or [frames x channels] at full scale 1."""
        path = self.output / "sound.wav"
        job = program.idiophone("timbre", scene, *arguments, "--set", "wav_full_scale=1", "-o", path)
        self.require_status(job, status)
        self.said = job.stdout + job.stderr
        return scipy.io.wavfile.read(path)[1].astype(float) if status == program.FINISHED else None

    def scene(self, text):
        path = self.output / "scene.yaml"
        path.write_text(text)
        return path


def seconds(sound, begin, end):
    return sound[int(begin * RATE):int(end * RATE)]


def level(sound):
    return numpy.sqrt(numpy.mean(sound ** 2))


def band(sound, lowest, highest):
    """Level between two frequencies."""
    spectrum = numpy.abs(numpy.fft.rfft(sound * numpy.hanning(len(sound)))) / len(sound)
    frequency = numpy.fft.rfftfreq(len(sound), 1 / RATE)
    return numpy.sqrt(numpy.sum(spectrum[(frequency >= lowest) & (frequency <= highest)] ** 2))


def pitches(sound, lowest, highest):
    """The frequency of the strongest line in each tenth of a second."""
    found = []
    for begin in range(0, len(sound) - RATE // 10, RATE // 10):
        part = sound[begin:begin + RATE // 10]
        spectrum = numpy.abs(numpy.fft.rfft(part * numpy.hanning(len(part)), 1 << 16))
        frequency = numpy.fft.rfftfreq(1 << 16, 1 / RATE)
        allowed = (frequency > lowest) & (frequency < highest)
        found.append(frequency[allowed][numpy.argmax(spectrum[allowed])])
    return numpy.array(found)


def notes_on(midi):
    """(number, velocity) of every note of a MIDI file that begins."""
    data = midi.read_bytes()
    found, at = [], 14
    while at < len(data):
        length, = struct.unpack(">I", data[at + 4:at + 8])
        end, at, status = at + 8 + length, at + 8, 0
        while at < end:
            while data[at] & 0x80:  # time
                at += 1
            at += 1
            if data[at] & 0x80:
                status, at = data[at], at + 1
            if status == 0xFF:
                at += 2 + data[at + 1]
            else:
                if status & 0xF0 == 0x90 and data[at + 1] > 0:
                    found.append((data[at], data[at + 1]))
                at += 1 if status & 0xF0 in (0xC0, 0xD0) else 2
    return found
