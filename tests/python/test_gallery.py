# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The gallery has every example, and its page is what tools/gallery.py writes."""

import pathlib
import runpy

import pytest

pytest.importorskip("matplotlib")

from PIL import Image  # noqa: E402

ROOT = pathlib.Path(__file__).parents[2]
GALLERY = runpy.run_path(str(ROOT / "tools" / "gallery.py"))


def test_page_has_every_example():
    page = (ROOT / "docs" / "gallery.md").read_text()
    names = GALLERY["names"]()
    assert [name[:2] for name in names] == [f"{k + 1:02}" for k in range(len(names))]
    assert page == GALLERY["HEAD"] + "".join(map(GALLERY["entry"], names))
    assert {path.stem for path in (ROOT / "docs" / "gallery").iterdir()} == set(names)


@pytest.mark.parametrize("name", GALLERY["names"]())
def test_picture_is_small_and_not_blank(name):
    path = ROOT / "docs" / "gallery" / f"{name}.png"
    assert path.stat().st_size <= GALLERY["LARGEST"]
    with Image.open(path) as picture:
        assert picture.width == GALLERY["WIDTH"]
        assert len(picture.getcolors()) > 10


def test_planners_move():
    path = ROOT / "docs" / "planners.gif"
    assert path.stat().st_size <= 2_500_000
    with Image.open(path) as picture:
        assert picture.n_frames > 30
        pages = []
        for k in (0, picture.n_frames // 2):
            picture.seek(k)
            pages.append(picture.convert("RGB"))
    third = pages[0].width // 3
    for k in range(3):
        first, other = (page.crop((k * third, 0, (k + 1) * third, page.height)) for page in pages)
        assert first.tobytes() != other.tobytes()
