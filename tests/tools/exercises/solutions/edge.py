# SPDX-License-Identifier: Apache-2.0


def edge_of(row):
    carpet, line = sum(row[:9]) / 9.0, sum(row[-9:]) / 9.0
    shares = [(value - carpet) / (line - carpet) for value in row]
    # The area above the step is as far as the step is from the end.
    return len(row) - 0.5 - sum(shares)
