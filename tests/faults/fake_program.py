#!/usr/bin/env python3
"""A program that only writes a report, in one of several ways: fake_program.py WAY report FOLDER -o FILE."""
import os
import sys
import time

TEXT = b"the report, first half; " + b"second half\n"


def write_all(file, text):
    while text:
        text = text[os.write(file, text):]


def careful(name):
    """A temporary file that takes the place of the old one when it is whole."""
    temporary = name + ".tmp"
    try:
        file = os.open(temporary, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        write_all(file, TEXT)
        os.fsync(file)
        os.close(file)
        os.rename(temporary, name)
    except OSError:
        if os.path.exists(temporary):
            os.unlink(temporary)
        raise


def in_place(name):
    file = os.open(name, os.O_WRONLY | os.O_TRUNC | os.O_CREAT)
    write_all(file, TEXT[:24])
    write_all(file, TEXT[24:])


def deaf(name):
    """Half a file, where a write fails, and status 0."""
    file = os.open(name + ".tmp", os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    for half in (TEXT[:24], TEXT[24:]):
        try:
            os.write(file, half)
        except OSError:
            pass
    os.rename(name + ".tmp", name)


def idle(name):
    """The old file stays where the new one cannot be written, and status 0."""
    try:
        careful(name)
    except OSError:
        pass


def untidy(name):
    """What was half written stays beside the old one, under a name that no later run knows."""
    temporary = f"{name}.{os.getpid()}"
    file = os.open(temporary, os.O_WRONLY | os.O_CREAT)
    write_all(file, TEXT)
    os.rename(temporary, name)


def mute(name):
    try:
        careful(name)
    except OSError:
        sys.exit(3)


def signalled(name):
    try:
        careful(name)
    except OSError:
        os.abort()


def is_there(name):
    try:
        os.stat(name)
        return True
    except FileNotFoundError:
        return False


def write_older(name):
    """The one to be replaced."""
    with open(name, "wb") as file:
        file.write(b"an older report\n")


def endless(name):
    file = os.open(name + ".tmp", os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    write_all(file, TEXT)
    try:
        os.rename(name + ".tmp", name)
    except OSError:
        time.sleep(1000)


WAYS = {way.__name__: way for way in (careful, in_place, deaf, idle, untidy, mute, signalled, endless)}


def main():
    way, *words = sys.argv[1:]
    if words[0] != "report":
        return
    try:
        if is_there(words[3]):
            WAYS[way](words[3])
        else:
            write_older(words[3])
    except OSError as error:
        sys.exit(f"{words[3]}: {error.strerror}")


if __name__ == "__main__":
    main()
