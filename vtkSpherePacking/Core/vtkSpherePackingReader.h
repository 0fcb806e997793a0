// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSpherePackingReader
 * @brief   read a sphere packing from a file
 *
 * The output is a vtkPolyData with a point and a vertex per sphere and the point array `radius`,
 * which is its active scalars. Further columns of numbers become point arrays of type double, named
 * as in the file or else `column_5` and so on; further columns with text in them become arrays of
 * strings. Diameters are halved, never passed as radii.
 *
 * | format      | extension                    | content                                          |
 * |-------------|------------------------------|--------------------------------------------------|
 * | SPHERES     | .spheres, .txt, any other    | `x y z r` per line                               |
 * | XYZR        | .xyzr                        | `x y z r`, with ids or flags before or behind it |
 * | YADE        | any, with a line `#format`   | `#format x_y_z_r_matId` names the columns        |
 * | CSV         | .csv                         | a header names x, y, z and r, radius, d, diameter|
 * | XYZD        | .xyzd                        | little-endian float64 x y z diameter             |
 * | DUMP        | .dump, .lammpstrj, .liggghts | LAMMPS or LIGGGHTS text dump                     |
 * | PQR         | .pqr                         | records that end with x y z charge radius        |
 * | SPHERE_TREE | .sph                         | levels of spheres, with an int array `level`     |
 * | LAMMPS_DATA | .data, any other             | input of read_data, atom_style sphere, granular  |
 * | XYZ         | .xyz, .extxyz, any other     | frames of extended XYZ, Properties with a radius |
 * | MERCURY     | .data, any other             | .data of MercuryDPM, in three dimensions or two  |
 * | DOCK        | .sph, by content             | clusters of spheres by sphgen, array `cluster`   |
 * | HOLE        | .sph, by content             | spheres of a pore, arrays `plane`, `end`, `name` |
 * | SWC         | .swc, .eswc, or by content   | `id type x y z radius parent` of a neuron        |
 * | GENGEO      | .geo, or by content          | particles and box of GenGeo, ESyS-Particle       |
 * | MEDIAL_AXIS | .ma, or by content           | vertices of a medial mesh                        |
 * | KRATOS      | .mdpa, or by content         | nodes of Kratos that have a radius               |
 * | PACKLSD     | any, by content              | a packing and its cell by PackLSD                |
 * | ESYS        | any, by content              | NAME_0.txt, a snapshot of ESyS-Particle          |
 *
 * Text may have blanks, tabs, commas or semicolons between the columns, blank lines, comments that
 * begin with #, lines that end in LF, CR LF or CR, and a byte order mark: of UTF-8, UTF-16 or
 * UTF-32. In CSV an empty field of a further column is NaN.
 *
 * A header, by itself or as a comment before the first row, names the columns in SPHERES, XYZR and
 * YADE, too; so does one comment for each column. YADE's #format comes before comments. Numbers of
 * columns before the names ("2:x") and units after them ("x [mm]", "x mm", "x/mm", of one unit for
 * centres and radii) are understood, and for centres also pos_x, x_pos, center_x, cx, Points:0 and
 * the like. The names of a comment may stand in any brackets or between any rules: "[x, y, z, d]",
 * "x | y | z | d", "xyzd". The full words radius and diameter come before r and d, and these before
 * names such as Rp, r_eff, d_eq and radius_mm. R beside G and B is red, not a radius: these become
 * an array `rgb`, of bytes for whole numbers up to 255 and of floats for numbers up to 1. r beside
 * an angle such as theta or phi is a distance, unless Columns calls it r. Radius and diameter are
 * understood in German, French, Italian, Spanish, Russian and Chinese, too, and one name for all
 * coordinates, as in "position diameter". A header may have no name for an index that counts the
 * rows before all columns, as pandas and R write it.
 *
 * By their places, the first four columns are x, y, z and radius: if nobody names columns, if the
 * first four names are these, or if there are only four. It is an error if a comment names columns
 * in a way that is not certain or that is not x, y, z and radius, if a comment about rows without
 * certain names may speak of diameters or of several units of length, in whatever words, or if a
 * comment further down names other columns than those before it. So it is if whole numbers in the
 * first of five or more columns may be ids or kinds, or if the first row may be a count and a box.
 * Columns says what they are.
 *
 * Numbers are rounded once, to the precision of the output, as by strtod and strtof, in any locale.
 *
 * Atoms have the arrays `name`, `residue`, `residue_id` and, where a record has them, `chain`,
 * `insertion_code` and `element`. Of a PQR file with several models the first is read, and the
 * field array `models` says how many there are. The trees of the Sphere-Tree Construction Toolkit
 * have the arrays `level`, `occupancy` and `parent`, the index of a sphere or -1; nodes with a
 * negative radius are left out. Cluster 0 of DOCK holds all spheres before they were clustered. The
 * array `plane` of HOLE is -888 or -999 for spheres that lie beside the planes of the pore, `end`
 * is 1 for those that only bound it. A PDB or mmCIF file, by name or content, is an error, since it
 * has no radii, and so is a .pqr file with occupancies and B-factors in the columns of a PDB file.
 *
 * The diameters of .xyzd are scaled by ((1 - final) / (1 - theoretical porosity))^(1/3) if there is
 * a file of the same name with the extension .nfo in the same folder. Scaled coordinates xs, ys,
 * zs of a dump, which are fractions of the simulation cell, are converted to coordinates in space.
 *
 * The steps of a dump, an extended XYZ or a MercuryDPM file are the time steps of the output;
 * without a request for a time the first is read. Their values are the numbers of the file, if each
 * step has one and these increase. If not, since a run was restarted or the file gives none, they
 * are 0, 1, 2 and so on. The field array `TimeValue` has the file's own number, GetStepTimes() that
 * of each step. A dump may have both ITEM: TIME and ITEM: TIMESTEP, an extended XYZ Time, Timestep
 * and Step: the first of these that increases is taken. A step without spheres has no points. A
 * last step that was cut before it says what it is, since the run was stopped, is left out; one
 * that was cut later is an error when it is read.
 *
 * A snapshot of ESyS-Particle is a file that names those with the particles, one per worker of the
 * run; they are looked for beside it. Its time is the number of the step times their length.
 *
 * The simulation cell of a file, such as a dump or an extended XYZ, becomes the field arrays
 * `cell_vectors` (three tuples a, b, c), `cell_origin` and `cell_periodic` (1 for periodic). Files
 * of LAMMPS data and IMD do not say along which axes their cells are periodic and count as periodic
 * along all, which is the default of these programs, a MercuryDPM file and a dump whose BOX BOUNDS
 * have no flags along none. A MercuryDPM file in two dimensions has no cell, and z is 0. Components
 * vx, vy, vz also become one array `velocity`, and so on.
 *
 * A last line without a line end is an error in what only programs write: dumps, LAMMPS data,
 * MercuryDPM, extended XYZ, IMD, PackLSD, trees of the toolkit and the atoms of PQR. They end every
 * line, so that the file was cut, perhaps within a number.
 *
 * An error in any line of the file leaves the output empty: one error is reported through
 * vtkErrorMacro, GetErrorCode() is set, and GetErrorMessage() is the sentence that names the file
 * and line, what was found and what was expected. Centres must be finite, radii finite and not
 * negative; a radius of 0 is valid. A file without spheres is an error, unless it is a time step.
 *
 * Text is parsed in parallel by vtkSMPTools. The peak memory is that of the file (of a dump: the
 * step) and of the output.
 *
 * @sa vtkSpherePackingWriter, vtkSpherePackingInput
 */
#ifndef vtkSpherePackingReader_h
#define vtkSpherePackingReader_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSpherePackingCoreModule.h" // for the export macro

#include <memory> // for std::unique_ptr
#include <string> // for std::string

namespace spherepacking
{
class PackingArrays;
class Progress;
enum class Format;
struct ReadOptions;
}

class vtkDoubleArray;

class VTKSPHEREPACKINGCORE_EXPORT vtkSpherePackingReader : public vtkPolyDataAlgorithm
{
public:
  static vtkSpherePackingReader* New();
  vtkTypeMacro(vtkSpherePackingReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum FileFormats
  {
    AUTO,
    SPHERES,
    XYZR,
    YADE,
    CSV,
    XYZD,
    DUMP,
    PQR,
    SPHERE_TREE,
    LAMMPS_DATA,
    XYZ,
    MERCURY,
    DOCK,
    HOLE,
    SWC,
    GENGEO,
    MEDIAL_AXIS,
    KRATOS,
    PACKLSD,
    ESYS
  };

  ///@{
  /**
   * The file to read. Default null, which is an error on update.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * The format of the file. Default AUTO: by its extension, or by its content where the extension
   * is not enough. Values outside of FileFormats are clamped.
   */
  vtkSetClampMacro(Format, int, AUTO, ESYS);
  vtkGetMacro(Format, int);
  ///@}

  ///@{
  /**
   * The precision of centres and radii: vtkAlgorithm::DOUBLE_PRECISION or DEFAULT_PRECISION for
   * double, the default, or vtkAlgorithm::SINGLE_PRECISION for float. Other values are clamped.
   */
  vtkSetClampMacro(OutputPointsPrecision, int, SINGLE_PRECISION, DEFAULT_PRECISION);
  vtkGetMacro(OutputPointsPrecision, int);
  ///@}

  ///@{
  /**
   * The minimum number of bytes of text that a thread parses at a time, 1 or more, default 262144;
   * lower values are clamped. The output does not depend on it.
   */
  vtkSetClampMacro(ChunkSize, vtkIdType, 1, VTK_ID_MAX);
  vtkGetMacro(ChunkSize, vtkIdType);
  ///@}

  ///@{
  /**
   * The names of the columns of a table in text, separated by blanks or commas, such as
   * "id x y z r"; - or _ is a column to skip. Then neither a header nor comments decide, lines of
   * words before the first row are skipped, and every row must have as many columns. Default null
   * or empty: they are found. Also names those of LAMMPS_DATA, of the section Atoms, and of XYZ
   * without Properties; with other formats the update is an error, and without x, y and z.
   */
  vtkSetStringMacro(Columns);
  vtkGetStringMacro(Columns);
  ///@}

  ///@{
  /**
   * Whether a file without radii is read, into an output without the array `radius`. Default off:
   * such a file is an error.
   */
  vtkSetMacro(RadiusOptional, bool);
  vtkGetMacro(RadiusOptional, bool);
  vtkBooleanMacro(RadiusOptional, bool);
  ///@}

  /**
   * The file's own number of each time step, as of the last UpdateInformation(): its time, or the
   * number of the time step where the file has no times. NaN where a step has none. Unlike the time
   * steps of the output they may repeat or run backwards. Empty for formats without time steps.
   */
  vtkDoubleArray* GetStepTimes() const;

  /**
   * What the file calls the column that has become the array `radius`, such as `d`, as of the last
   * update; `radius` where it has no name, and empty where there are no radii.
   */
  const char* GetRadiusName() const { return this->RadiusName.c_str(); }

  /**
   * The error of the last update, in one sentence; empty when there was none.
   */
  const char* GetErrorMessage() const { return this->ErrorMessage.c_str(); }

protected:
  vtkSpherePackingReader();
  ~vtkSpherePackingReader() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSpherePackingReader(const vtkSpherePackingReader&) = delete;
  void operator=(const vtkSpherePackingReader&) = delete;

  void ReadFile(vtkInformation* outInfo, vtkPolyData* output);
  void ReadStep(spherepacking::Format format, const std::string& file,
    const spherepacking::ReadOptions& options, spherepacking::Progress& progress,
    vtkInformation* outInfo, vtkPolyData* output);
  void TakeArrays(spherepacking::PackingArrays arrays, vtkPolyData* output);
  std::string OutOfMemory() const;

  char* FileName = nullptr;
  int Format = AUTO;
  int OutputPointsPrecision = DOUBLE_PRECISION;
  vtkIdType ChunkSize = 1 << 18;
  char* Columns = nullptr;
  bool RadiusOptional = false;
  std::string ErrorMessage;
  std::string RadiusName;

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
