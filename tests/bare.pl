#!/usr/bin/perl -0777p
# tests/bare.pl: C without comments, blank lines and indentation, for a fingerprint that no compiler has a part in.
my $quoted = qr/"(?:[^"\\]|\\.)*"|'(?:[^'\\]|\\.)*'/s;
s{($quoted)|/\*.*?\*/|//[^\n]*}{$1 // " "}gse;
s{($quoted)|\s+}{$1 // ($& =~ /\n/ ? "\n" : " ")}gse;
