# Units of the dearest frame: of a run with everything at level 1, what budgets are multiples of. After bench/tables/columns.awk.
{ if (cell("cost_units") > most) most = cell("cost_units") }
END { print most }
