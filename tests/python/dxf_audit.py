# SPDX-License-Identifier: GPL-3.0-or-later
"""What a program that is not ours finds of DXF files: ezdxf has nothing to mend in them."""

try:
    import ezdxf
except ImportError:
    ezdxf = None


def assert_audited(path):
    """The document of a DXF file, which has no errors and none that were fixed on reading. None
    without ezdxf, by which nothing is found then."""
    if ezdxf is None:
        return None
    document = ezdxf.readfile(path)
    audit = document.audit()
    assert [(found.code, found.message) for found in audit.errors + audit.fixes] == []
    return document
