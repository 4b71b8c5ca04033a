# SPDX-FileCopyrightText: The ElastoPlasticContact authors
# SPDX-License-Identifier: LGPL-2.1-or-later

# Doxygen's filter for Markdown pages, which are written for web sites with
# repositories. Formulas are written $...$, and $$ on lines of their own; Doxygen
# wants \f$...\f$, \f[ and \f]. A formula may go over several lines. A link to a
# heading, #its-words or ../part/page.md#its-words, needs a label at the heading, and
# labels are those of all pages: page-its-words. Comments mark computed numbers.

function label(heading) {
  heading = tolower(heading)
  gsub(/[^a-z0-9 _-]/, "", heading)
  gsub(/ /, "-", heading)
  return page "-" heading
}

/^ ? ? ?<!-- .* -->$/ {
  next
}

FNR == 1 {
  page = FILENAME
  sub(/.*\//, "", page)
  sub(/\.md$/, "", page)
}

/^\$\$$/ {
  print displayed ? "\\f]" : "\\f["
  displayed = !displayed
  next
}

displayed {
  print
  next
}

!/^    / {
  gsub(/<!-- [a-zA-Z0-9_.]+ -->/, "")
}

{
  gsub(/\$/, "\\f$")
  gsub(/\]\(#/, "](#" page "-")
  sub(/^\[[a-z0-9_]+\]: #/, "&" page "-")
  while (match($0, /\]\([a-zA-Z0-9_.\/]*\.md#/)) {
    target = substr($0, RSTART + 2, RLENGTH - 6)
    sub(/.*\//, "", target)
    $0 = substr($0, 1, RSTART + 1) "#" target "-" substr($0, RSTART + RLENGTH)
  }
}

/^## / {
  in_section = 1 # what a label of a smaller heading needs
}

(/^##+ / && in_section) || (/^# / && FNR == 1 && page != "README") {
  heading = $0
  sub(/^#+ /, "", heading)
  $0 = $0 " {#" label(heading) "}"
}

{ print }
