"""What proves a certificate again."""

from __future__ import annotations

import os
from pathlib import Path

from . import _tautline
from ._tautline import Certificate, NotCertified, Verdict


def check(certificate: Certificate | str | os.PathLike[str]) -> Verdict:
    """Proves the two numbers of a certificate again. Trusts none in its text.

    It is a certificate, its text, or the path of a file as `pathlib.Path`. Raises `NotCertified` if it is
    refused.
    """
    if isinstance(certificate, Certificate):
        return _tautline.check(certificate.text)
    if isinstance(certificate, os.PathLike):
        return _tautline.check(Path(certificate).read_text(encoding="utf-8"))
    if not isinstance(certificate, str):
        raise TypeError(f"{certificate!r} is no certificate, no text and no path")
    try:
        return _tautline.check(certificate)
    except NotCertified as error:
        if "\n" not in certificate and os.path.exists(certificate):
            hint = f"{error}; for the file of this name call check(pathlib.Path({certificate!r}))"
            raise NotCertified(hint) from None
        raise
