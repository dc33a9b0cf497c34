"""What the tests of the Python module share."""

import os

import pytest


@pytest.fixture
def program(monkeypatch):
    """The program zproof, which the test needs; POV-Ray is not asked, and the user's settings are not read."""
    monkeypatch.setenv("ZPROOF_ORACLE", "none")
    monkeypatch.setenv("ZPROOF_CONFIG", "none")
    return os.environ.get("ZPROOF_PROGRAM") or "zproof"
