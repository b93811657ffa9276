"""Why a certificate proves nothing."""


class Refused(Exception):
    """The certificate proves nothing, for this reason."""


def require(true, reason):
    if not true:
        raise Refused(reason)
