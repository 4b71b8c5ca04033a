# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# Doxygen's filter for Markdown pages: formulas are written $...$, and $$ on lines
# of their own, as web sites with repositories want it; Doxygen wants \f$...\f$,
# \f[ and \f]. A formula may go over several lines.

/^\$\$$/ {
  print displayed ? "\\f]" : "\\f["
  displayed = !displayed
  next
}

!displayed {
  gsub(/\$/, "\\f$")
}

{ print }
