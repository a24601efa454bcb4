"""A JACK server of our own without a sound card."""
import os
import subprocess
import time


def start(case, period=128, *options):
    """Starts it for a test. Returns its process and the environment in which programs find it.
    @param period   audio samples
    @param options  of jackd"""
    name = "idiophone_test"  # always the same: JACK keeps a place for each name, and has eight of them
    environment = {**os.environ, "JACK_DEFAULT_SERVER": name, "JACK_NO_AUDIO_RESERVATION": "1"}
    server = subprocess.Popen(["jackd", "--name", name, "--no-realtime", *options, "-d", "dummy", "-r", "48000", "-p", str(period)],
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    case.addCleanup(server.wait)
    case.addCleanup(server.terminate)  # it removes its socket; after a kill it would not
    for _ in range(100):
        if server.poll() is not None:
            break
        if subprocess.run(["jack_lsp"], capture_output=True, env=environment).returncode == 0:
            return server, environment
        time.sleep(0.2)
    case.fail("jackd does not start")
