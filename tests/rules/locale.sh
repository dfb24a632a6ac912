# SPDX-License-Identifier: MIT
# Numbers are read and written by base/number.h, which knows no locale: no %f, %g or %e in the library and the programs.
# (What a person alone reads, such as a profile's report, is held to the same.)
. "$ROOT/tests/check.sh"
cd "$ROOT/src" || exit 1
formats=$(grep -nE '"[^"]*%[-+ #0]*[0-9*]*(\.[0-9*]+)?l?[aAeEfFgG]' {base,list,profile,input,plan,stroke,surface,api,tool}/*.[ch] 2>/dev/null | grep -vE '^[^:]*:[0-9]+: \*|^[^:]*:[0-9]+:[[:space:]]*(/\*|//)')
report "no locale-dependent number formats" "$formats"
readers=$(grep -nE '\b(strtod|strtof|strtold|atof|[fs]?scanf)[[:space:]]*\(' {base,list,profile,input,plan,stroke,surface,api,tool}/*.[ch] 2>/dev/null)
report "no locale-dependent number readers" "$readers"
