"""Are two folders of results of one run? Byte for byte, but for times."""
import json
import re
from pathlib import Path


def without_times(file):
    """The list of files keeps their names alone, for their lengths and sums hold the times."""
    data = file.read_bytes()
    if file.name == 'results.json':
        results = json.loads(data)
        for view in results['views']:
            view['times'] = {}
        results['run'].update(command='', argv=[], threads=0)  # the words of -o and -j
        return json.dumps(results)
    if file.name == '.zproof-out':
        return re.sub(rb'[0-9]+ [0-9a-f]+ ', b'- ', data)
    if file.name == 'junit.xml':
        return re.sub(rb'time="[0-9.]+"', b'', data)
    return data


def files_in(folder):
    return {str(file.relative_to(folder)) for file in folder.rglob('*') if file.is_file()}


def differences(a, b, left_out=('report.html',)):
    """What differs, by name; the page, which shows times and the command, only by being there."""
    a, b = Path(a), Path(b)
    names = files_in(a) | files_in(b)
    return sorted(name for name in names
                  if not (a / name).is_file() or not (b / name).is_file()
                  or (name not in left_out and without_times(a / name) != without_times(b / name)))
