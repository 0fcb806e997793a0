// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSpherePackingWriter
 * @brief   write a sphere packing to a file
 *
 * The input is a vtkPolyData with a radius for each point.
 *
 * | format  | extension | content                                                               |
 * |---------|-----------|-----------------------------------------------------------------------|
 * | SPHERES | .spheres  | `x y z r` per line, largest first                                     |
 * | XYZR    | .xyzr     | `x y z r` per line                                                    |
 * | YADE    | .txt      | `#format x_y_z_r`, or `x_y_z_r_matId` with a point array of that name |
 * | CSV     | .csv      | `x,y,z,radius`, then a column per component of other arrays           |
 * | XYZD    | .xyzd     | little-endian float64 x y z diameter                                  |
 * | DUMP    | .dump     | a step of LAMMPS: time, cell, `x y z radius` and other arrays         |
 * | XYZ     | .xyz      | extended XYZ: time, cell, `pos`, `radius` and other arrays            |
 *
 * .lammpstrj and .liggghts are DUMP, too, .extxyz and .exyz XYZ. These and CSV hold all point
 * arrays, numbers and texts; the other formats leave them out. Vectors whose parts are arrays, too,
 * are left to the reader, which joins them. DUMP and XYZ hold the cell, that is the field arrays
 * `cell_vectors`, `cell_origin` and `cell_periodic`, and `TimeValue`; a DUMP without a time says 0.
 * A tilted cell that rounding would change among the bounds of a DUMP is written as one of general
 * vectors. Texts have to be without what separates them. Numbers get the shortest
 * digits that read back as the same double, which also read back as the same float, in any locale.
 *
 * The file is replaced atomically, once it is complete: an error, an abort, a full disk or the end
 * of the process leaves an earlier file of that name as it was. It gets the permissions and the
 * group of the earlier one; symbolic links are followed, other hard links keep the earlier content.
 * One error is reported through vtkErrorMacro, GetErrorCode() is set, and GetErrorMessage() is the
 * sentence that names the file or the array, what was found and what was expected. A packing
 * without spheres is an error.
 *
 * It derives from vtkPolyDataAlgorithm rather than from vtkWriter, because what a subclass of
 * vtkWriter has to override changed between VTK 9.6 and 9.7.
 *
 * @sa vtkSpherePackingReader, vtkSpherePackingInput
 */
#ifndef vtkSpherePackingWriter_h
#define vtkSpherePackingWriter_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSpherePackingCoreModule.h" // for the export macro
#include "vtkSpherePackingReader.h"     // for the formats

#include <string> // for std::string

class VTKSPHEREPACKINGCORE_EXPORT vtkSpherePackingWriter : public vtkPolyDataAlgorithm
{
public:
  static vtkSpherePackingWriter* New();
  vtkTypeMacro(vtkSpherePackingWriter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to write. Default null, which is an error on writing.
   */
  virtual void SetFileName(VTK_FILEPATH const char* text);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * The format of the file, one of vtkSpherePackingReader::FileFormats. Default AUTO: by the
   * extension. Other values are clamped; those that cannot be written are an error on writing.
   */
  vtkSetClampMacro(Format, int, vtkSpherePackingReader::AUTO, vtkSpherePackingReader::MERCURY);
  vtkGetMacro(Format, int);
  ///@}

  ///@{
  /**
   * The name of the point array with the radii, in the unit of the points. Default "radius". An
   * array that is missing or does not hold radii is an error on writing.
   */
  vtkSetStringMacro(RadiusArrayName);
  vtkGetStringMacro(RadiusArrayName);
  ///@}

  ///@{
  /**
   * Whether SPHERES is written largest first, on which readers of that format may rely; spheres of
   * equal radius stay in order. Default on. Off writes the order of the points, as in the other
   * formats.
   */
  vtkSetMacro(SortByRadius, bool);
  vtkGetMacro(SortByRadius, bool);
  vtkBooleanMacro(SortByRadius, bool);
  ///@}

  /**
   * Writes the file. Returns 1, or 0 after an error or an abort.
   */
  int Write();

  /**
   * Whether a packing can be written to that file, as far as that is known without one: 1, or 0
   * after an error, such as a folder that is write-protected. No file is made.
   */
  int CheckFile();

  /**
   * The error of the last Write() or CheckFile(), in one sentence; empty when there was none.
   */
  const char* GetErrorMessage() const { return this->ErrorMessage.c_str(); }

protected:
  vtkSpherePackingWriter();
  ~vtkSpherePackingWriter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSpherePackingWriter(const vtkSpherePackingWriter&) = delete;
  void operator=(const vtkSpherePackingWriter&) = delete;

  void WriteFile(vtkPolyData* packing);

  char* FileName = nullptr;
  bool FileNameLost = false; // there was no memory for it
  char* RadiusArrayName = nullptr;
  int Format = vtkSpherePackingReader::AUTO;
  bool SortByRadius = true;
  bool Written = false;
  std::string ErrorMessage;
};

#endif
