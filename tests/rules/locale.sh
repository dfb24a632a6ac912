# SPDX-License-Identifier: MIT
# The library may be called from a program with a decimal comma. Numbers in files are read and written by base/number/number.h,
# which knows no locale; only a message for a person may use %g. The programs never leave the C locale.
. "$ROOT/tests/check.sh"
cd "$ROOT/src" || exit 1
library=$(ls {base,list,profile,input,plan,stroke,surface,api}/*.[ch])
# shellcheck disable=SC2086
formats=$(grep -nE '\b(fprintf|[v]?snprintf|sprintf)\b.*"[^"]*%[-+ #0]*[0-9*]*(\.[0-9*]+)?l?[aAeEfFgG]' $library)
report "no locale-dependent number formats in what the library writes" "$formats"
# shellcheck disable=SC2086
readers=$(grep -nE '\b(strtod|strtof|strtold|atof|[fs]?scanf)[[:space:]]*\(' $library)
report "no locale-dependent number readers in the library" "$readers"
report "nobody sets a locale" "$(grep -nE '\bsetlocale[[:space:]]*\(' $(find . -name '*.[ch]' | sed 's|^./||') | grep -v '^tap/')"
