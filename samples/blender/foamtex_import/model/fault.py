# SPDX-License-Identifier: Apache-2.0
"""The error that the add-on reports to its user."""


class Fault(Exception):
    """A problem that the user can solve. The message is one line that names the file and what is allowed."""
