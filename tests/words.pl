#!/usr/bin/perl
# tests/words.pl FILE...: words in prose that a reader has to translate. Prose is what stands outside chunks, code, mathematics,
# TeX comments, the arguments that name something, and quotations, ``...'' or `...'. Prints FILE:LINE: WORD; ends with 1 if there are any.
use strict;
use warnings;

my @words = qw(nobody somebody whoever whosoever whichever lest nought whence thence hither whereof thereof whereby herein therein ere
  albeit he him his himself tells told foretold foretells anew twain befalls? befell betray(?:s|ed)? heed(?:s|ed|ing)? vainly nigh
  betwixt oft dwells? dwelt suffic(?:es?|ed));
my @phrases = ('but for', 'save for', 'the former', 'the latter', 'as it were', 'by and by', 'in vain', 'of late', 'at all events',
  'is no one', '(?<!and so )forth', 'lays? hold', 'needs must');
my $refused = join '|', @words, map { s/(?<!so) (?!so|\))/\\s+/gr } @phrases;

# What is no prose becomes blank, so that the lines keep their numbers.
sub blank { $_[0] =~ s/[^\n]/ /gr }

# The prose of a chapter, or of a TeX file, which has no chunks.
sub of_tex {
  my ($text, $is_web) = @_;
  if ($is_web) {
    my $inside = 0;
    $text = join '', map {
      $inside = 1 if /^<<.*>>=\s*$/;
      $inside = 0 if /^@(?: |$)/;
      $inside || /^@(?: %def|$)/ ? blank($_) : $_
    } split /^/, $text;
    $text =~ s/(\[\[.*?\]\]+|<<[^\n]*?>>)/blank($1)/gse;
  }
  $text =~ s/(?<!\\)(%[^\n]*)/blank($1)/ge;
  $text =~ s/(\\begin\{(equation|align|gather|multline|verbatim|terminal)(\*?)\}.*?\\end\{\2\3\})/blank($1)/gse;
  $text =~ s/((?<!\\)\\\[.*?\\\]|\$\$.*?\$\$)/blank($1)/gse;
  $text =~ s/((?<!\\)\$(?:[^\$\\]|\\.)*\$)/blank($1)/gse;
  $text =~ s/(``.*?'')/blank($1)/gse;
  $text =~ s/((?<![\\`])`(?:(?!\n\s*\n)[^`']){1,600}')/blank($1)/gse;
  $text =~ s/(\\(?:val(?:only|err)?)(?:\{[^{}]*\}){2})/blank($1)/ge;
  $text =~ s/(\\(?:cite|label|(?:page|eq)?ref|input|url|texttt|begin|end|plot|bibliography|includegraphics)\*?(?:\[[^\]]*\])?\{[^{}]*\})/blank($1)/ge;
  return $text;
}

# The prose of a page in Markdown.
sub of_markdown {
  my ($text) = @_;
  $text =~ s/^(```.*?^```)/blank($1)/gmse;
  $text =~ s/^((?: {4}|\t)[^\n]*)/blank($1)/gme;
  $text =~ s/(`[^`]*`)/blank($1)/gse;
  $text =~ s/("[^"\n]*(?:\n[^"\n]+)?")/blank($1)/gse;
  return $text;
}

my $bad = 0;
for my $file (@ARGV) {
  open(my $in, '<', $file) or die "$file: $!\n";
  my $text = do { local $/; <$in> };
  my $prose = $file =~ /\.md$/ ? of_markdown($text) : of_tex($text, $file =~ /\.nw$/);
  while ($prose =~ /(?<![\w\\])($refused)(?!\w)/gi) {
    my ($word, $at) = ($1, $-[1]);
    my $line = 1 + (substr($prose, 0, $at) =~ tr/\n//);
    print "$file:$line: ", $word =~ s/\s+/ /gr, "\n";
    $bad = 1;
  }
}
exit $bad;
