"""A terminal to type in, on a graph."""

import pytest

from tflab.tools.page import run_words, split_line


class Terminal:
    """Types lines, and reads what is printed."""

    def __init__(self, graph, capsys):
        self.graph = graph
        self._capsys = capsys
        self.exit_code = None
        self.error = ""
        self.pictures = ()

    def type(self, line):
        """Run a line that begins with `ros2`; return standard output; `error` and `exit_code` are kept."""
        self._capsys.readouterr()
        seconds, words = split_line(line)
        self.exit_code, self.pictures = run_words(self.graph, words, seconds)
        captured = self._capsys.readouterr()
        self.error = captured.err
        return captured.out


@pytest.fixture
def terminal(graph, capsys):
    return Terminal(graph, capsys)
