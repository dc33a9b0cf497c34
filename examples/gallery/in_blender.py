"""Runs a script in Blender, where it is imported as well: its arguments stand behind --."""
import subprocess
import sys

IS_HERE = 'bpy' in sys.modules


def arguments():
    return sys.argv[sys.argv.index('--') + 1:]


def run(script, *arguments):
    subprocess.run(['blender', '--background', '--factory-startup', '--python-exit-code', '1', '--python', script,
                    '--', *arguments], check=True, stdout=subprocess.DEVNULL)
