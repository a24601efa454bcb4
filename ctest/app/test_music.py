#!/usr/bin/python3
"""The music of `idiophone timbre`: MIDI and MusicXML have the same notes, and the score's measures are complete."""
import os
import shutil
import subprocess
import unittest
import xml.etree.ElementTree

import program
from timbre_case import TimbreCase, notes_on

SCENE = """name: s
duration: 4.9
classes: {silence: silence.tt, walk: walk.tt}
sounds: {s: {class: silence, duration: 0.01}}
variables: {loud: {keys: [[0, 30], [4, 127]]}}
music:
  every: 0.2
  parts:
    walk: {class: walk, parameters: {speed: {keys: [[0, 0.1], [5, 0.9]]}}, from: [0, 1], scale: blues, tonic: 49, octaves: 3,
           velocity: loud, program: {keys: [[0, 11], [2, 14]], interpolation: hold}, steps: {class: walk, parameters: {speed: 7}},
           rest: {value: {class: walk, parameters: {speed: 0.5}}, below: 0.2}}
    slow: {class: walk, parameters: {speed: 0.05}, from: [0, 1], scale: lydian, tonic: 66, octaves: 1}
"""
TREE = "(parameter speed)\n(* speed (+ 0.5 (* 0.5 (sine 0.7))))\n"
SEMITONES = {"C": 0, "D": 2, "E": 4, "F": 5, "G": 7, "A": 9, "B": 11}
TYPES = {"whole": 32, "half": 16, "quarter": 8, "eighth": 4, "16th": 2, "32nd": 1}


def number_of(note):
    """The MIDI note of an element <note>; none for a rest."""
    pitch = note.find("pitch")
    if pitch is None:
        return None
    return SEMITONES[pitch.findtext("step")] + int(pitch.findtext("alter", "0")) + 12 * (int(pitch.findtext("octave")) + 1)


class Music(TimbreCase):
    def setUp(self):
        super().setUp()
        (self.output / "silence.tt").write_text("(* 0 time)")
        (self.output / "walk.tt").write_text(TREE)

    def score(self):
        self.timbre(self.scene(SCENE))
        return xml.etree.ElementTree.parse(self.output / "sound.musicxml").getroot()

    def test_measures_are_complete_and_ties_lead_to_the_same_note(self):
        score = self.score()
        self.assertEqual([part.findtext("part-name") for part in score.iter("score-part")], ["walk", "slow"])
        rests, ties, bars = 0, 0, 0
        for part in score.findall("part"):
            measures = part.findall("measure")
            self.assertEqual(len(measures), 4)  # 25 steps, eighths
            self.assertEqual([measure.get("number") for measure in measures], ["1", "2", "3", "4"])
            attributes = measures[0].find("attributes")
            self.assertEqual(attributes.findtext("divisions"), "8")
            self.assertEqual((attributes.findtext("time/beats"), attributes.findtext("time/beat-type")), ("4", "4"))
            tied = None  # the note that a tie leads from
            for measure in measures:
                notes = measure.findall("note")
                self.assertEqual(sum(int(note.findtext("duration")) for note in notes), 32)
                bars += tied is not None
                for note in notes:
                    length = TYPES[note.findtext("type")]
                    dots = len(note.findall("dot"))
                    self.assertEqual(int(note.findtext("duration")), length * 2 - length // 2 ** dots)
                    marks = [mark.get("type") for mark in note.findall("tie")]
                    self.assertEqual(marks, [mark.get("type") for mark in note.findall("notations/tied")])
                    self.assertEqual("stop" in marks, tied is not None)
                    if tied is not None:
                        self.assertEqual(number_of(note), tied)
                    tied = number_of(note) if "start" in marks else None
                    ties += tied is not None
                    rests += note.find("rest") is not None
            self.assertIsNone(tied)
        self.assertGreater(rests, 2)
        self.assertGreater(ties, 2)
        self.assertGreater(bars, 0)

    def test_the_score_has_the_notes_of_the_midi_file(self):
        score = self.score()
        heard = notes_on(self.output / "sound.mid")
        instruments, found = {}, []
        for instrument in score.iter("midi-instrument"):
            instruments[instrument.get("id")] = int(instrument.findtext("midi-program"))
        for note in score.iter("note"):
            if number_of(note) is not None and "stop" not in [tie.get("type") for tie in note.findall("tie")]:
                found.append((number_of(note), round(0.9 * float(note.get("dynamics")))))
                self.assertIn(note.find("instrument").get("id"), instruments)
        self.assertEqual(found, heard)
        self.assertEqual(sorted(instruments.values()), [1, 12, 15])
        self.assertGreater(len({velocity for _, velocity in heard}), 5)
        self.assertEqual(score.find("part/measure/direction/sound").get("tempo"), "150")  # an eighth is 0.2 s

    @unittest.skipUnless(shutil.which("musescore3"), "needs musescore3")
    def test_musescore_reads_the_same_notes(self):
        self.score()
        read = self.output / "read.mid"
        environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", HOME=str(self.output), XDG_RUNTIME_DIR=str(self.output))
        job = subprocess.run(["musescore3", "-o", read, self.output / "sound.musicxml"], env=environment, capture_output=True,
                             text=True, timeout=program.TIMEOUT)
        self.require_status(job, 0)
        for complaint in ("not a valid MusicXML file", "Error"):  # it checks the schema, and then what it reads
            self.assertNotIn(complaint, job.stdout + job.stderr)
        self.assertEqual([number for number, _ in notes_on(read)],
                         [number for number, _ in notes_on(self.output / "sound.mid")])

    def test_mistakes_are_reported(self):
        for said, wanted in (
                ("{class: walk, channel: a, from: [0, 1], scale: blues}", "has no meaning with class"),
                ("{class: walk, from: [0, 1], scale: blues}", "the parameter 'speed' has no default"),
                ("{class: wakl, from: [0, 1], scale: blues}", "(did you mean 'walk'?)"),
                ("{class: walk, parameters: {speed: {event: force}}, from: [0, 1], scale: blues}", "no contact starts the music"),
                ("{class: walk, parameters: {speed: 1}, from: [0, 1], scale: blues, steps: 0}", "must be at least 1"),
                ("{class: walk, parameters: {speed: 1}, from: [0, 1], scale: blues, velocity: 128}", "at most 127"),
                ("{class: walk, parameters: {speed: 1}, from: [0, 1], scale: blues, rest: {value: 1}}", "'below'")):
            text = SCENE[:SCENE.index("    walk: {class")] + "    walk: " + said + "\n"
            self.timbre(self.scene(text), status=program.WRONG_DECK)
            self.assertIn(wanted, self.said)


if __name__ == "__main__":
    unittest.main()
