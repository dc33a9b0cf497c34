"""What a notebook shows of frames, verdicts and tables: HTML that needs nothing from the network."""

import base64
import html
import struct
import zlib

import numpy

from zproof import _zproof

_LARGEST = 480  # screen pixels along a side; larger pictures are shown smaller, and small ones enlarged
_LARGEST_ZOOM = 8
_CROP, _CROP_ZOOM = 32, 6  # pixels around the worst
_MOST_DEFECTS, _MOST_ROWS = 8, 20


def add_representations():
    """Gives the classes their _repr_html_, and a repr() to those of the extension that have none."""
    from zproof.filters import Table

    _zproof.Frame._repr_html_ = frame_html
    _zproof.Verdict._repr_html_ = verdict_html
    Table._repr_html_ = table_html
    _zproof.Finding.__repr__ = finding_text
    _zproof.NearTriangle.__repr__ = near_triangle_text


def finding_text(finding):
    """<zproof.Finding at (812, 344): hidden, 7 for 5319>"""
    ids = f"{_id(finding.id)} for {_id(finding.reference_id)}"
    return f"<zproof.Finding at ({finding.x}, {finding.y}): {finding.class_name}, {ids}>"


def near_triangle_text(triangle):
    """<zproof.NearTriangle 5319: admissible, depth 5.858>"""
    word = "admissible" if triangle.is_admissible else "not admissible"
    return f"<zproof.NearTriangle {triangle.id}: {word}, depth {triangle.bound[1]:.6g}>"


def frame_html(frame):
    """Ids and depth, side by side."""
    height, width = frame.id.shape
    step = _step(frame.id)
    return _row([_figure(f"triangle ids, {width} x {height}", id_colours(frame.id[::step, ::step])),
                 _figure("camera depth, near is bright", depth_greys(frame.depth[::step, ::step]))])


def verdict_html(verdict):
    """The class of every pixel, how many there are of each, the surroundings of the worst, and a list."""
    from zproof.judging import summary

    height, width = verdict.classes.shape
    step = _step(verdict.classes)
    caption = f"class of every pixel, {width} x {height}"
    if step > 1:
        caption += f"; the severest of {step} x {step}"
    picture = _figure(caption, class_colours(severest(verdict.classes, step)))
    parts = [f"<p><b>{html.escape(summary(verdict))}</b></p>", _row([picture, _counts_html(verdict)])]
    if verdict.defects:
        parts.append(f"<p>{html.escape(str(verdict.diagnosis))}</p>")
    worst = worst_first(verdict)
    if len(worst):
        parts += [_surroundings_html(verdict, worst[0]), _worst_html(verdict, worst)]
    return "".join(parts)


def table_html(table):
    """The first rows of a study. What is the same in all is said once; columns of nothing are left out."""
    same = {name: values[0] for name, values in table.items()
            if len(values) > 1 and (values == values[0]).all()}
    columns = [name for name, values in table.items() if name not in same and not _is_empty(values)]
    shown = range(min(len(table), _MOST_ROWS))
    rows = [[_cell(table[column][i], digits=4) for column in columns] for i in shown]
    parts = [_table(columns, rows)]
    if same:
        said = ", ".join(f"{html.escape(name)} {_cell(value)}" for name, value in same.items())
        parts.insert(0, f"<p>{said}</p>")
    if len(table) > len(rows):
        parts.append(f"<p>and {len(table) - len(rows)} more rows</p>")
    return "".join(parts)


def id_colours(ids):
    """A colour for each id, the same every time: uint8 (height, width, 3). Background is black."""
    mixed = (ids.astype(numpy.uint64) + 1) * numpy.uint64(0x9E3779B97F4A7C15)
    channels = [(mixed >> numpy.uint64(shift)) & numpy.uint64(0xBF) for shift in (24, 36, 48)]
    colours = numpy.stack(channels, -1).astype(numpy.uint8) + numpy.uint8(64)
    colours[ids == _zproof.BACKGROUND_ID] = 0
    return colours


def depth_greys(depth):
    """Inverse depth from dark to bright, over its range: uint8 (height, width, 3). Background is black."""
    seen = numpy.isfinite(depth) & (depth > 0)
    greys = numpy.zeros(depth.shape, numpy.uint8)
    if seen.any():
        inverse = 1 / depth[seen].astype(float)
        least, most = inverse.min(), inverse.max()
        greys[seen] = 64 + (191 * (inverse - least) / ((most - least) or 1)).astype(numpy.uint8)
    return numpy.repeat(greys[..., None], 3, -1)


def class_colours(classes):
    """The report's colours: uint8 (height, width, 3)."""
    colours = [[value >> 16 & 255, value >> 8 & 255, value & 255] for value in _zproof.CLASS_COLOURS]
    return numpy.array(colours, numpy.uint8)[classes]


def worst_first(verdict):
    """The findings of all defects, or of undecidable pixels where there is none, the largest error over its
    bound first, as the report ranks them."""
    found = verdict.findings
    is_asked = found["is_defect"] == 1
    if not is_asked.any():
        is_asked = found["class"] == _zproof.CLASS_NAMES.index("undecidable")
    found = found[is_asked]
    error = numpy.nan_to_num(found["error_over_bound"], nan=-1)
    return found[numpy.argsort(-error, kind="stable")]


def severest(classes, step):
    """One pixel for each step x step: the severest class of them, so that no defect is lost."""
    height, width = classes.shape
    padded = numpy.zeros((-(-height // step) * step, -(-width // step) * step), numpy.uint8)
    padded[:height, :width] = classes
    return padded.reshape(padded.shape[0] // step, step, -1, step).max(axis=(1, 3))


def framed(pixels, x, y, zoom):
    """Enlarged, with a frame of white and black around pixel (x, y)."""
    large = pixels.repeat(zoom, axis=0).repeat(zoom, axis=1)
    for margin, colour in ((2, 0), (1, 255)):
        top, left = max(0, y * zoom - margin), max(0, x * zoom - margin)
        large[top:(y + 1) * zoom + margin, left:(x + 1) * zoom + margin] = colour
    large[y * zoom:(y + 1) * zoom, x * zoom:(x + 1) * zoom] = pixels[y, x]
    return large


def png(pixels):
    """A PNG file of uint8 (height, width, 3)."""
    height, width, _ = pixels.shape
    rows = numpy.zeros((height, 1 + 3 * width), numpy.uint8)  # filter 0 before each row
    rows[:, 1:] = pixels.reshape(height, 3 * width)

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(rows.tobytes()))
            + chunk(b"IEND", b""))


def _counts_html(verdict):
    rows = []
    for number, name in enumerate(_zproof.CLASS_NAMES):
        if count := verdict.counts[name]:
            colour = f"#{_zproof.CLASS_COLOURS[number]:06x}"
            swatch = f'<span style="background:{colour};border:1px solid #888">&emsp;</span> {name}'
            word = "fails" if _zproof.is_defect(number) else "passes"
            rows.append([swatch, f"{count:,}", "undecided" if name == "undecidable" else word])
    return _table(["class", "pixels", "gate"], rows)


def _surroundings_html(verdict, worst):
    """The worst pixel in a frame, and what lies around it, enlarged."""
    height, width = verdict.classes.shape
    x, y = int(worst["x"]), int(worst["y"])
    left, top = max(0, min(x - _CROP // 2, width - _CROP)), max(0, min(y - _CROP // 2, height - _CROP))
    crop = numpy.s_[top:top + _CROP, left:left + _CROP]
    pictures = [("class", class_colours(verdict.classes[crop])), ("ids", id_colours(verdict.id[crop])),
                ("reference ids", id_colours(verdict.reference.id[crop]))]
    figures = [_figure(caption, framed(pixels, x - left, y - top, _CROP_ZOOM), 1)
               for caption, pixels in pictures]
    return f"<p>Around the worst pixel, ({x}, {y}):</p>" + _row(figures)


def _worst_html(verdict, worst):
    rows = [[f"{f['x']}, {f['y']}", _zproof.CLASS_NAMES[f["class"]], _id(f["id"]), _cell(f["depth"]),
             _id(f["reference_id"]), _cell(f["reference_depth"]), _cell(f["error_over_bound"], digits=3)]
            for f in worst[:_MOST_DEFECTS]]
    heading = ["x, y", "class", "id", "depth", "reference id", "reference depth", "error / bound"]
    what = "defects" if verdict.defects else "undecidable pixels"
    return f"<p>The worst of {len(worst):,} {what}:</p>" + _table(heading, rows)


def _id(value):
    return "background" if value == _zproof.BACKGROUND_ID else str(value)


def _is_empty(values):
    return values.dtype.kind == "f" and bool(numpy.isnan(values).all())


def _cell(value, digits=6):
    text = f"{value:.{digits}g}" if isinstance(value, (float, numpy.floating)) else str(value)
    return html.escape("" if text == "nan" else text)


def _table(heading, rows):
    """Numbers to the right, and words to the left."""
    def cell(tag, text, is_word):
        return f'<{tag} style="text-align:{"left" if is_word else "right"};white-space:nowrap">{text}</{tag}>'

    is_word = [not all(text[:1] in "-0123456789" or text == "inf" for text in column)
               for column in zip(*rows)]
    is_word += [True] * (len(heading) - len(is_word))  # where there are no rows
    head = "".join(cell("th", html.escape(name), left) for name, left in zip(heading, is_word))
    lines = ["".join(cell("td", text, left) for text, left in zip(row, is_word)) for row in rows]
    body = "".join(f"<tr>{line}</tr>" for line in lines)
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def _step(plane):
    """Every which pixel is shown."""
    return -(-max(plane.shape) // _LARGEST)


def _figure(caption, pixels, zoom=None):
    height, width, _ = pixels.shape
    zoom = zoom or max(1, min(_LARGEST_ZOOM, _LARGEST // max(width, height)))
    data, said = base64.b64encode(png(pixels)).decode(), html.escape(caption)
    return (f'<figure style="margin:4px"><img alt="{said}" width="{zoom * width}" height="{zoom * height}" '
            'style="image-rendering:pixelated;max-width:none;border:1px solid #888" '
            f'src="data:image/png;base64,{data}"><figcaption>{said}</figcaption></figure>')


def _row(parts):
    style = "display:flex;flex-wrap:wrap;gap:8px;align-items:flex-start"
    return f'<div style="{style}">' + "".join(f"<div>{part}</div>" for part in parts) + "</div>"
