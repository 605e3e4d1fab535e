# tests/small.sh: sourced; small_scenes DIR writes scenes there that have, together, every maker, shake and measure.
# check-bytes.sh holds the first five to the same bytes here, slow-compilers.sh all of them elsewhere.
small_scenes() {
cat > "$1/mixed.scene" <<'END'
dimension = 3; seed = 31; realizations = 5; box = [1.0, 1.3, 0.9]; gap = 0.02; save = true;
species = ( { name = "A"; radius = 1.0; volume = 0.5; }, { name = "B"; radius = 0.6; volume = 0.3; },
            { name = "C"; radius = 0.31; volume = 0.2; } );
number = 700; fraction = 0.27;
make = { method = "rsa"; order = "large first"; };
measure = { rdf = { reach = 4.0; estimator = "central"; }; nearest = {}; order = {};
            histogram = { centre = "random"; windows = 1000; }; coordination = { tolerance = 0.05; };
            pores = { points = 2000.0; }; surface = { points = 500.0; }; cluster = {};
            structure = { reach = 6.0; vectors = 300.0; }; chords = { lines = 200.0; };
            S2 = { step = 0.5; reach = 3.0; }; S3 = { step = 1.0; reach = 3.0; samples = 1024.0; }; };
END
cat > "$1/discs.scene" <<'END'
dimension = 2; seed = 9007199254740992; realizations = 7; side = 30.0; fraction = "max"; save = true;
species = ( { name = "disc"; radius = 1.0; share = 0.25; }, { name = "dot"; radius = 0.4; share = 0.75; } );
make = { method = "rsa"; };
measure = { rdf = { reach = 9.0; step = 0.1; }; K = {}; approach = {}; order = {}; histogram = {}; };
END
cat > "$1/shapes.scene" <<'END'
dimension = 2; seed = 11; realizations = 3; fraction = 0.3; save = true;
species = ( { name = "P"; radius = 1.0; number = 60; shape = { kind = "polygon"; sides = 5; }; },
            { name = "Q"; radius = 0.7; number = 40; shape = { kind = "polygon"; vertices = ([0, 0], [3, 0], (1, 2.5)); }; },
            { name = "S"; radius = 1.5; number = 50; shape = { kind = "superellipse"; aspect = 1.5; m = 1.7; }; },
            { name = "D"; radius = 0.5; number = 20; } );
make = { method = "points"; };
measure = { rdf = { reach = 5.0; }; nearest = {}; order = {};
            pores = { points = 2000.0; }; surface = { points = 500.0; }; cluster = { points = 500.0; };
            structure = { reach = 6.0; }; chords = { lines = 200.0; };
            bounds = { pixels = 6.0; conductivity = [1.0, 10.0]; bulk = [1.0, 3.0]; shear = [1.0, 2.0]; };
            boolean = { reach = 3.0; }; S2 = { step = 0.5; reach = 3.0; }; S3 = { step = 1.0; reach = 3.0; samples = 1024.0; }; };
END
cat > "$1/grown.scene" <<'END'
dimension = 3; seed = 5; realizations = 3; save = true; box = [1.0, 1.0, 1.5];
species = ( { name = "A"; radius = 1.0; number = 60; }, { name = "B"; radius = 0.4; number = 200; } ); fraction = 0.5;
make = { method = "crm"; growth = 0.2; mass = "volume"; rest = 4; };
measure = { rdf = { reach = 3.0; }; order = {}; pressure = { warm = 4; blocks = 4; each = 4; }; };
sweep = ( { key = "make.protocol"; values = ("literal", "isothermal"); }, { key = "make.start"; values = ("points", "rsa"); } );
END
cat > "$1/shaken.scene" <<'END'
dimension = 3; seed = 6; realizations = 2; save = true; number = 150; fraction = 0.5;
species = ( { name = "A"; radius = 1.0; volume = 0.7; }, { name = "B"; radius = 0.5; volume = 0.3; sizes = { law = "lognormal"; spread = 0.2; }; } );
make = { method = "crm"; growth = 0.2; };
shake = { radius = 0.05; sweeps = 6; samples = 2; apart = 2; };
measure = { partials = { scale = "r"; reach = [3.0]; window = 2.5; }; };
sweep = ( { key = "shake.rule"; values = ("metropolis", "retry", "collision", "collision-longest", "chain", "newton", "dynamics"); } );
END
cat > "$1/field.scene" <<'END'
dimension = 3; seed = 7; realizations = 2; save = true; cube = 1.0; fraction = 0.4; dilute = { part = 0.5; };
species = ( { name = "fine"; radius = 1.0; number = 1000; },
            { name = "coarse"; radius = 2.0; number = 30; grow = "mark"; sizes = { law = "lognormal"; spread = 0.2; least = 1.5; most = 2.5; }; } );
make = { method = "gravity"; };
measure = { rdf = { reach = 4.0; }; nearest = {}; coordination = {}; radial = {}; profile = {}; order = {};
            partials = { scale = "r"; reach = [4.0, 4.5, 4.5]; }; };
sweep = ( { key = "dilute.range"; values = ("surfaces", "centres"); } );
END
cat > "$1/flat.scene" <<'END'
dimension = 2; seed = 8; realizations = 2; save = true;
species = ( { name = "disc"; radius = 1.0; number = 400; }, { name = "coarse"; radius = 3.0; number = 9; grow = "add"; } );
make = { method = "gravity"; };
measure = { rdf = { reach = 6.0; }; K = {}; coordination = {}; order = {}; };
sweep = ( { key = "make.mode"; values = ("adaptive", "literal"); } );
END
cat > "$1/lattice.scene" <<'END'
dimension = 3; save = true; species = ( { name = "site"; radius = 1.0; } );
make = { method = "lattice"; lattice = "simple cubic"; n_l = 2; };
measure = { shells = { reach = 10.0; }; rdf = { reach = 4.5; }; K = { reach = 4.5; }; I = { reach = 4.5; }; order = {}; };
sweep = ( { key = "make.lattice"; values = ("simple cubic", "bcc", "fcc"); } );
END
cat > "$1/points.scene" <<'END'
dimension = 3; seed = 4; realizations = 3; save = true; number = 500; fraction = 0.3;
species = ( { name = "A"; volume = 0.6; sizes = { law = "power"; exponent = -2.0; least = 0.5; most = 1.5; }; },
            { name = "B"; radius = 0.5; volume = 0.4; } );
make = { method = "points"; };
measure = { histogram = {}; nearest = {}; K = {}; };
END
cat > "$1/fluid.scene" <<'END'
dimension = 3; seed = 9; realizations = 2; number = 300; fraction = 0.4; save = true;
species = ( { name = "A"; radius = 1.0; volume = 0.7; }, { name = "B"; radius = 0.7; volume = 0.3; } );
make = { method = "crm"; growth = 0.2; };
measure = { rdf = { reach = 3.0; }; quotients = { at = 2.0; steps = [0.01, 0.02]; };
            partials = { reach = [3.0]; }; pressure = { warm = 4; blocks = 4; each = 4; }; };
theory = { mixture = true; };
END
}
