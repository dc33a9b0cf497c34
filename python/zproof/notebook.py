"""What a notebook shows of frames, verdicts and tables: HTML that needs nothing from the network."""

import base64
import html
import struct
import zlib

import numpy

from zproof import _zproof

_WIDEST = 480  # pixels of a picture; larger ones are shown by every nth pixel
_MOST_ROWS = 20


def add_html():
    """Gives the classes their _repr_html_."""
    _zproof.Frame._repr_html_ = frame_html
    _zproof.Verdict._repr_html_ = verdict_html
    from zproof.filters import Table

    Table._repr_html_ = table_html


def frame_html(frame):
    """Ids and depth, side by side."""
    height, width = frame.id.shape
    return _figures([(f"triangle ids, {width} x {height}", id_colours(frame.id)),
                     ("camera depth, near is bright", depth_greys(frame.depth))])


def verdict_html(verdict):
    """The class of every pixel, how many there are of each, and the worst."""
    from zproof.judging import summary

    parts = [f"<p><b>{html.escape(summary(verdict))}</b></p>",
             _figures([("class of every pixel", class_colours(verdict.classes))]), _counts_html(verdict)]
    if verdict.defects:
        parts += [f"<p>{html.escape(str(verdict.diagnosis))}</p>", _worst_html(verdict)]
    return "".join(parts)


def table_html(table):
    """The first rows of a study."""
    columns = list(table)
    rows = [[_cell(table[column][i]) for column in columns] for i in range(min(len(table), _MOST_ROWS))]
    left = len(table) - len(rows)
    return _table(columns, rows) + (f"<p>and {left} more rows</p>" if left else "")


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
            rows.append([swatch, f"{count:,}", "fails" if _zproof.is_defect(number) else ""])
    return _table(["class", "pixels", "gate"], rows)


def _worst_html(verdict):
    """Severest class first, then the largest error over its bound."""
    found = verdict.findings
    found = found[[_zproof.is_defect(number) for number in found["class"]]]
    error = numpy.nan_to_num(found["error_over_bound"], nan=-1)
    worst = found[numpy.lexsort((-error, -found["class"].astype(int)))][:_MOST_ROWS]
    rows = [[f"{f['x']}, {f['y']}", _zproof.CLASS_NAMES[f["class"]], _id(f["id"]), _cell(f["depth"]),
             _id(f["reference_id"]), _cell(f["reference_depth"]), _cell(f["error_over_bound"])] for f in worst]
    heading = ["x, y", "class", "id", "depth", "reference id", "reference depth", "error / bound"]
    return f"<p>The worst of {verdict.defects:,} defects:</p>" + _table(heading, rows)


def _id(value):
    return "background" if value == _zproof.BACKGROUND_ID else str(value)


def _cell(value):
    text = f"{value:.6g}" if isinstance(value, (float, numpy.floating)) else str(value)
    return html.escape("" if text == "nan" else text)


def _table(heading, rows):
    head = "".join(f"<th>{html.escape(name)}</th>" for name in heading)
    body = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows)
    return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"


def _figures(pictures):
    figures = []
    for caption, pixels in pictures:
        step = -(-pixels.shape[1] // _WIDEST)
        data = base64.b64encode(png(pixels[::step, ::step])).decode()
        said = html.escape(caption + (f", every {step}. pixel" if step > 1 else ""))
        figures.append(f'<figure style="display:inline-block;margin:4px"><img alt="{said}" '
                       f'src="data:image/png;base64,{data}"><figcaption>{said}</figcaption></figure>')
    return "<div>" + "".join(figures) + "</div>"
