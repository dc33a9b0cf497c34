"""What the tests of the Python module share."""

import os

import pytest


@pytest.fixture
def program(monkeypatch):
    """The program zproof, which the test needs. POV-Ray is not asked, nor are the user's settings read."""
    monkeypatch.setenv("ZPROOF_ORACLE", "none")
    monkeypatch.setenv("ZPROOF_CONFIG", "none")
    return os.environ.get("ZPROOF_PROGRAM") or "zproof"
