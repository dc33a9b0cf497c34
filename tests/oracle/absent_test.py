#!/usr/bin/env python3
"""What stands in for a driver that is not built in defines all that other rooms call of that driver.

    absent_test.py NM ABSENT.o... -- LIBRARY...     the libraries of rooms other than oracle
"""
import re
import subprocess
import sys


def symbols(nm, files, kind):
    printed = subprocess.run([nm, '-C', kind, *files], check=True, stdout=subprocess.PIPE, text=True).stdout
    names = re.findall(r'^[0-9a-f ]*[A-Za-z] (zproof::oracle::.*)$', printed, flags=re.MULTILINE)
    return {name for name in names if re.search(r'vulkan|OpenGl|opengl_', name, flags=re.IGNORECASE)
            and 'oracle::opengl::' not in name}  # zproof-filters stands in for those itself


def main():
    nm, *rest = sys.argv[1:]
    middle = rest.index('--')
    called = symbols(nm, rest[middle + 1:], '--undefined-only')
    assert any('vulkan_devices' in name for name in called), f'nobody calls vulkan_devices(): {called}'
    of_rooms = symbols(nm, rest[middle + 1:], '--defined-only')
    missing = called - of_rooms - symbols(nm, rest[:middle], '--defined-only')
    assert not missing, f'not defined where the driver is absent: {sorted(missing)}'


main()
