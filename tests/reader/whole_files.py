"""A small file of each format in text, of two spheres or more, in which every line ends.

The numbers have fixed decimals, since nothing tells that the last digit of a number is missing
where others of its column are as short.
"""

DUMP = """ITEM: UNITS
lj
ITEM: TIME
0.125
ITEM: TIMESTEP
100
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS pp pp ff
0 10.5
0 11.5
0 12.5
ITEM: ATOMS id type x y z radius
1 1 1.25 2.25 3.25 0.339
2 1 4.25 5.25 6.25 0.427
"""
LATER = DUMP.partition("ITEM: TIME\n")[2].replace("0.125", "0.250").replace("\n100\n", "\n200\n")
ROWS = "1.125 2.125 3.125 0.339\n4.125 5.125 6.125 0.427\n7.125 8.125 9.125 0.519\n"
ATOM = "ATOM      1  N   ALA A   1      -0.750  -1.125  -0.375  0.1414 1.8240\n"
ATOMS = ATOM + ATOM.replace("     1  N", "     2  C") + ATOM.replace("     1  N", "     3  O")
HOLE = (
    "ATOM      1  QSS SPH S   0       1.250  -2.500   3.750  1.40  1.40\n"
    "ATOM      1  QSS SPH S  -1       1.250  -2.500   4.000  1.50  0.00\n"
    "LAST-REC-END\n"
    "ATOM      1  QSS SPH S-888    -101.250-202.500-304.000  7.25999.99\n"
)
LAMMPS = """LAMMPS data file via write_data, version 22 Jul 2025

2 atoms
1 atom types
0 10.5 xlo xhi
0 11.5 ylo yhi
0 12.5 zlo zhi

Atoms # sphere

1 1 0.875 2.5 1.25 2.25 3.255
2 1 0.875 2.5 4.25 5.25 6.255
"""
VELOCITIES = (
    "\nVelocities\n\n1 0.125 0.225 0.325 1.5 2.5 3.125\n2 0.125 0.225 0.325 1.5 2.5 3.225\n"
)
DOCK = (
    "DOCK 3.5 receptor_spheres\n"
    "red\n"
    "cluster     1   number of spheres in cluster     2\n"
    "    7   1.25000  -2.50000   3.75000   1.400   12 1  0\n"
    "    9  -1.00000   2.00000   0.50000   3.125   15 1 10\n"
    "cluster     2   number of spheres in cluster     1\n"
    "   11-123.12500-456.25000-789.50000   1.40099999 2 12\n"
)
GEO = """LSMGeometry 1.2
BoundingBox 0 0 0 10.5 10.5 10.5
PeriodicBoundaries 1 0 0
Dimension 3D
BeginParticles
Simple
2
1.25 2.25 3.25 0.339 1 7
4.25 5.25 6.25 0.427 2 8
EndParticles
BeginConnect
1
0 1 12
EndConnect
"""
MDPA = """Begin ModelPartData
End ModelPartData
Begin Properties 0
End Properties
Begin Nodes
1 1.25 2.25 3.25
2 4.25 5.25 6.25
End Nodes
Begin Elements SphericParticle3D
1 0 1
2 0 2
End Elements
Begin NodalData RADIUS
1 0 0.339
End NodalData
Begin NodalData RADIUS
2 0 0.427
End NodalData
Begin NodalData COHESIVE_GROUP
1 0 1
End NodalData
"""
LSD = "3\n2 1\n2\n{}1.5 0 0\n0 2.5 0\n0.5 0 3.5\nT T F\n"
MERCURY = (
    "2 {} 0 0 0 9 9 9 \n"
    "1.25 2.25 3.25 0 0 0 0.339 0 0 0 0 0 0 10 \n"
    "4.25 5.25 6.25 0 0 0 0.427 0 0 0 0 0 0 12 \n"
)
XYZ = (
    "2\nProperties=species:S:1:pos:R:3:radius:R:1 Time={}\n"
    "A 1.25 2.25 3.25 0.339\nB 4.25 5.25 6.25 0.427\n"
)
IMD = "#F A 1 0 0 3 0 1\n#C number x y z Radius\n#X 10.5 0 0\n#Y 0 10.5 0\n#Z 0 0 10.5\n#E\n"
TREE = "2 2\n0 0 0 1.525 0.995\n0.5 0 0 0.625 0.895\n-0.5 0 0 0.525 0.125\n"
SWC = "# a\n1 1 0.5 1.5 2.5 6.339 -1\n12 3 1.5 1.5 2.5 0.715 1\n35 3 2.5 1.5 2.5 0.515 12\n"

# The name, the text and options of each.
WHOLE = {
    "dump": ("p.dump", DUMP, {}),
    "dump of two steps": ("p.dump", DUMP + "ITEM: TIME\n" + LATER, {}),
    "table": ("p.spheres", ROWS, {}),
    "csv": ("p.csv", "x,y,z,r\n" + ROWS.replace(" ", ","), {}),
    "csv of ParaView": (
        "p.csv",
        '"radius","Points:0","Points:1","Points:2"\n0.339,1.125,2.125,3.125\n0.427,4.125,5.125,6.125\n'
        "0.519,7.125,8.125,9.125\n",
        {},
    ),
    "Voronota": (
        "p.xyzr",
        "A 1 N 1.25 2.25 3.25 1.339\nA 12 C 4.25 5.25 6.25 1.427\nA 13 O 7.25 8.25 9.25 1.519\n",
        {},
    ),
    "MSMS": ("p.xyzr", ROWS, {}),
    "Voro++": (
        "p.vol",
        "".join(f"{i} {row}\n" for i, row in enumerate(ROWS.splitlines(), 1)),
        {"columns": "id x y z r"},
    ),
    "extended XYZ": ("p.xyz", XYZ.format(0.5), {}),
    "extended XYZ of two frames": ("p.xyz", XYZ.format(0.5) + XYZ.format(1.5), {}),
    "plain XYZ": (
        "p.xyz",
        "2\ncomment\nA 1.25 2.25 3.25 0.339\nB 4.25 5.25 6.25 0.427\n",
        {"columns": "element x y z r"},
    ),
    "plain XYZ without radii": (
        "p.xyz",
        "2\ncomment\nA 1.25 2.25 3.339\nB 4.25 5.25 6.427\n",
        {"optional": True},
    ),
    "SWC": ("p.swc", SWC, {}),
    "LAMMPS data": ("p.data", LAMMPS, {}),
    "LAMMPS data and velocities": ("p.data", LAMMPS + VELOCITIES, {}),
    "LAMMPS data by people": ("p.data", LAMMPS.replace(LAMMPS.splitlines()[0], "balls"), {}),
    "cellPACK": (
        "p.sph",
        "# rmin rmax\n0.25 4\n# number of levels\n2\n# n\n1\n1.25 2.25 3.25 4.25\n"
        "2\n1.25 2.25 3.25 0.39\n5.25 6.25 7.25 0.25\n",
        {},
    ),
    "YADE": ("p.txt", "#format x_y_z_r\n" + ROWS.replace(" ", "\t"), {}),
    "YADE, SpherePack": (
        "p.txt",
        "##PERIODIC:: 10.5 11.5 12.5\n" + ROWS.replace("\n", " -1\n"),
        {},
    ),
    "IMD": ("p.imd", IMD + "1 1.25 2.25 3.25 0.339\n2 4.25 5.25 6.25 0.427\n", {}),
    "PQR in columns": ("p.pqr", "REMARK 1 a\n" + ATOMS + "TER\nEND\n", {}),
    "PQR between blanks": (
        "p.pqr",
        "ATOM 1 N ALA A 1 -0.75 -1.125 -0.375 0.1414 1.8240\n"
        "HETATM 2 O HOH A 12 1.75 -1.125 -0.375 -0.834 1.6612\nTER\n"
        "HETATM 3 O HOH A 13 2 -3 4 -0.834 1.6612\nEND\n",
        {},
    ),
    "tree of the toolkit": ("p.sph", TREE, {}),
    "DOCK": ("p.sph", DOCK, {}),
    "HOLE": ("p.sph", HOLE, {}),
    "GenGeo": ("p.geo", GEO, {}),
    "medial axis": (
        "p.ma",
        "2 1 0\nv 1.25 2.25 3.25 0.339\nv 4.25 5.25 6.25 0.427\ne 0 1\n",
        {},
    ),
    "medial axis without edges": (
        "p.ma",
        "2 0 0\nv 1.25 2.25 3.25 0.339\nv 4.25 5.25 6.25 0.427\n",
        {},
    ),
    "medial axis without letters": (
        "p.ma",
        "2 1 1\n1.25 2.25 3.25 0.339\n4.25 5.25 6.25 0.427\n0 1\n0 1 1\n",
        {},
    ),
    "Kratos": ("p.mdpa", MDPA, {}),
    "PackLSD": (
        "p.dat",
        LSD.format("") + "0.25 0.25 0.25 0.339\n0.75 0.25 0.25 0.427\n",
        {},
    ),
    "PackLSD of one size": (
        "p.dat",
        LSD.format("0.339\n") + "0.25 0.25 0.251\n0.75 0.25 0.253\n",
        {},
    ),
    "MercuryDPM": ("p.data", MERCURY.format(0.5), {}),
    "MercuryDPM, two steps": ("p.data", MERCURY.format(0.5) + MERCURY.format(1.5), {}),
}
