"""Where VTK draws."""

import os
import sys

VIRTUAL = "IDIOPHONE_VIRTUAL_DISPLAY"  # set where the script runs on one


def enter_virtual_display():
    """Starts the script again on a display of its own: Debian's VTK needs one even off screen, and aborts where
    DISPLAY names one that does not answer."""
    if VIRTUAL not in os.environ:
        os.execvpe("xvfb-run", ["xvfb-run", "-a", sys.executable, *sys.argv], {**os.environ, VIRTUAL: "1"})
