# figures/tools/shares.awk, after pack.awk: the radii of a pack and the shares of the number and of the volume up to each: of some of the
# small, of all the large.
{ radius[particle] = r }
# Sorted by a heap.
function sink(i, n,   j, t) {
  for (; (j = 2 * i) <= n; i = j) {
    if (j < n && radius[j + 1] > radius[j]) j++
    if (radius[i] >= radius[j]) return
    t = radius[i]; radius[i] = radius[j]; radius[j] = t
  }
}
END {
  for (i = int(particle / 2); i; i--) sink(i, particle)
  for (n = particle; n > 1; n--) { t = radius[1]; radius[1] = radius[n]; radius[n] = t; sink(1, n - 1) }
  for (i = 1; i <= particle; i++) volume[i] = volume[i - 1] + radius[i] * radius[i] * radius[i]
  print "radius\tnumber\tvolume"
  for (i = 1; i <= particle; i++) if (i % 120 == 0 || i > 0.985 * particle && i % 4 == 0 || i > particle - 6)
    print radius[i] "\t" i / particle "\t" volume[i] / volume[particle]
}
