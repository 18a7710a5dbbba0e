# What the tables of bench/tables share. The first line of a CSV file names its columns; none of these has commas in its cells.
BEGIN { FS = "," }

FNR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }

# The cell of this line in the named column.
function cell(name) {
  if (!(name in column)) {
    print "the CSV file has no column " name > "/dev/stderr"
    exit failed = 1
  }
  return $column[name]
}

# Two digits that mean something.
function rounded(value) { return sprintf(value < 0.0995 ? "%.3f" : "%.2f", value) }

# A ratio's median and its extremes.
function spread(name) {
  return rounded(cell(name)) " (" rounded(cell(name "_min")) "-" rounded(cell(name "_max")) ")"
}

# Sorts the values 1 to n, and returns their median.
function median(values, n,    i, j, x) {
  for (i = 2; i <= n; ++i) {
    x = values[i]
    for (j = i; j > 1 && values[j - 1] > x; --j) values[j] = values[j - 1]
    values[j] = x
  }
  return n % 2 ? values[(n + 1) / 2] : (values[n / 2] + values[n / 2 + 1]) / 2
}

# The median of the values 1 to n, and their extremes.
function medianSpread(values, n,    middle) {
  middle = median(values, n)
  return rounded(middle) " (" rounded(values[1]) "-" rounded(values[n]) ")"
}

# A table's row of so many cells.
function row(cells, count,    text, i) {
  text = "|"
  for (i = 1; i <= count; ++i) text = text " " cells[i] " |"
  print text
}

function rule(count,    text, i) {
  text = "|"
  for (i = 1; i <= count; ++i) text = text "---|"
  print text
}

# Scenes are called after their family and their seed.
function sceneFamily(scene) {
  sub(/-[0-9]+$/, "", scene)
  return scene
}
