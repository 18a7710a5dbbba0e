# How budgets were kept in each family of scenes, and in all, in each of the files. After columns.awk.
function over(part, whole) { return whole > 0 ? sprintf("%.2f %%", 100 * part / whole) : "-" }
function usedBy(name, kind) { return overloaded[name, kind] > 0 ? sprintf("%.2f", used[name, kind] / overloaded[name, kind]) : "-" }
{
  for (kind = 1; FILENAME != ARGV[kind]; ++kind) {}
  family = cell("scene")
  sub(/-[0-9]+$/, "", family)
  if (!(family in known)) { known[family] = 1; families[++familyCount] = family }
  for (i = 1; i <= 2; ++i) {
    name = i == 1 ? family : "all"
    frames[name, kind] += cell("frames")
    over2[name, kind] += cell("over_2")
    over5[name, kind] += cell("over_5")
    if (cell("worst") > worst[name, kind]) worst[name, kind] = cell("worst")
    finest[name, kind, cell("floors")] += cell("finest"); ++count[name, kind, cell("floors")]
    used[name, kind] += cell("overloaded") * cell("use"); overloaded[name, kind] += cell("overloaded")
  }
}
# As a Markdown table. `kinds`: names of the files; `shows_levels`: at the end levels and use of the first, else the use of each.
END {
  if (failed) exit 1
  cells[1] = "family"
  kindCount = split(kinds, kind_names, ",")
  n = 1
  for (kind = 1; kind <= kindCount; ++kind) {
    cells[++n] = kind_names[kind] ": > 1.02"
    cells[++n] = "> 1.05"
    cells[++n] = "worst"
    if (!shows_levels) cells[++n] = "used"
  }
  if (shows_levels) {
    cells[++n] = "touching pairs at their finest level: 1.2"
    cells[++n] = "1.5"
    cells[++n] = "2"
    cells[++n] = "3 floors"
    cells[++n] = "used"
  }
  row(cells, n)
  rule(n)
  families[++familyCount] = "all"
  for (f = 1; f <= familyCount; ++f) {
    name = families[f]
    cells[1] = name == "all" ? "all" : "`" name "`"
    n = 1
    for (kind = 1; kind <= kindCount; ++kind) {
      cells[++n] = over(over2[name, kind], frames[name, kind])
      cells[++n] = over(over5[name, kind], frames[name, kind])
      cells[++n] = sprintf("%.2f", worst[name, kind])
      if (!shows_levels) cells[++n] = usedBy(name, kind)
    }
    if (shows_levels) {
      split("1.2 1.5 2 3", floors, " ")
      for (i = 1; i <= 4; ++i) cells[++n] = sprintf("%.0f %%", 100 * finest[name, 1, floors[i]] / count[name, 1, floors[i]])
      cells[++n] = usedBy(name, 1)
    }
    row(cells, n)
  }
}
