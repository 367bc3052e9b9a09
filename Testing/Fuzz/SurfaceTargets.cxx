#include "SurfaceTargets.h"

#include "BinaryFields.h"
#include "JsonMutator.h"
#include "MeshFormats.h"
#include "MeshGltf.h"
#include "ModelFile.h"
#include "ModelJson.h"
#include "RandomModels.h"
#include "SpharmPdmCoefficients.h"
#include "SurfaceFile.h"
#include "SyntheticSurfaces.h"
#include "TextMutator.h"

#include "vtkCellArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkStringArray.h"
#include "vtkXMLPolyDataWriter.h"

namespace palpate::test
{
namespace
{
TriangleMesh Tetrahedron()
{
  TriangleMesh mesh;
  mesh.PointsWorld = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}};
  mesh.Triangles = {{{0, 2, 1}}, {{0, 1, 3}}, {{0, 3, 2}}, {{1, 2, 3}}};
  mesh.Normals.assign(4, Vector3::UnitZ());
  mesh.Colors.assign(4, {{255, 128, 0}});
  mesh.Values = {{"error", {0.0, 0.5, -0.5, 1.0}}};
  return mesh;
}

std::string VtpText(int mode, bool isCompressed)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(PolyDataOf(Tetrahedron()));
  writer->WriteToOutputStringOn();
  writer->SetDataMode(mode);
  if (!isCompressed)
  {
    writer->SetCompressorTypeToNone();
  }
  writer->Write();
  return writer->GetOutputString();
}

std::vector<std::string> VtpSeeds()
{
  return {VtpText(vtkXMLWriter::Ascii, false), VtpText(vtkXMLWriter::Ascii, false),
          VtpText(vtkXMLWriter::Binary, true), VtpText(vtkXMLWriter::Appended, false)};
}

Mutator VtpMutator()
{
  const Mutator text = TextMutator({{"Int64",
                                     "Int32",
                                     "UInt8",
                                     "Float32",
                                     "Float64",
                                     "String",
                                     "ascii",
                                     "binary",
                                     "appended",
                                     "offset",
                                     "NumberOfComponents",
                                     "NumberOfTuples",
                                     "NumberOfPoints",
                                     "NumberOfPolys",
                                     "NumberOfStrips",
                                     "NumberOfVerts",
                                     "NumberOfLines",
                                     "connectivity",
                                     "offsets",
                                     "Polys",
                                     "Strips",
                                     "Verts",
                                     "Lines",
                                     "Points",
                                     "PointData",
                                     "CellData",
                                     "FieldData",
                                     "DataArray",
                                     "vtkZLibDataCompressor",
                                     "vtkLZ4DataCompressor",
                                     "LittleEndian",
                                     "BigEndian",
                                     "Piece",
                                     "UnstructuredGrid",
                                     "raw",
                                     "base64"},
                                    {{"<Piece>", "</Piece>"}, {"<a>", "</a>"}},
                                    ""});
  return OneOf({text, text, text, MutateBytes});
}

Mutator StlMutator()
{
  const Mutator fields = FieldMutator(
      []
      {
        std::vector<BinaryField> table = FieldsFrom(84, 50, 4, BinaryField::Type::Real);
        table.insert(table.end(), 10, {80, 4}); // triangles
        return table;
      }());
  const Mutator text = TextMutator(
      {{"facet", "normal", "outer", "loop", "vertex", "endloop", "endfacet", "solid", "endsolid"},
       {{"solid a\n", "endsolid\n"}},
       ""});
  return OneOf({fields, text, MutateBytes});
}

std::vector<std::string> StlSeeds()
{
  return {MeshToStl(Tetrahedron()),
          "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
          "endloop\nendfacet\nendsolid a\n"};
}

std::vector<std::string> PlySeeds()
{
  return {MeshToPly(Tetrahedron()),
          "ply\nformat ascii 1.0\ncomment SPACE=LPS\nelement vertex 4\nproperty float x\n"
          "property float y\nproperty float z\nproperty uchar red\nproperty uchar green\n"
          "property uchar blue\nelement face 2\nproperty list uchar int vertex_indices\n"
          "end_header\n0 0 0 1 2 3\n1 0 0 1 2 3\n0 1 0 1 2 3\n0 0 1 1 2 3\n3 0 1 2\n4 0 1 2 3\n"};
}

Mutator PlyMutator()
{
  const std::vector<std::string> words{"format ascii 1.0",
                                       "format binary_big_endian 1.0",
                                       "format binary_little_endian 1.0",
                                       "element vertex 1",
                                       "element face 4294967295",
                                       "element edge 3",
                                       "property double x",
                                       "property list uchar int vertex_indices",
                                       "property list int double vertex_index",
                                       "property list uint uint a",
                                       "property uchar red",
                                       "property char nx",
                                       "int8",
                                       "uint32",
                                       "float64"};
  const Mutator head = TextMutator({words, {}, "end_header\n"});
  const Mutator body = Behind(
      "end_header\n",
      OneOf({FieldMutator(FieldsFrom(0, 60, 4)), FieldMutator(FieldsFrom(1, 60, 4)), MutateBytes}));
  return OneOf({head, TextMutator({words, {}, ""}), body});
}

std::vector<std::string> LegacyVtkSeeds()
{
  const auto surface = PolyDataOf(Tetrahedron());
  vtkNew<vtkStringArray> names;
  names->SetName("names");
  names->InsertNextValue("two words");
  surface->GetFieldData()->AddArray(names);
  vtkNew<vtkCellArray> strips;
  strips->InsertNextCell({0, 1, 2, 3});
  surface->SetStrips(strips);
  std::vector<std::string> seeds;
  for (const int version : {42, 51})
  {
    seeds.push_back(LegacyVtkBytes(surface, version, false));
    seeds.push_back(LegacyVtkBytes(surface, version, true));
  }
  return seeds;
}

Mutator LegacyVtkMutator()
{
  const Mutator text = TextMutator({{"ASCII",
                                     "BINARY",
                                     "POLYDATA",
                                     "POINTS",
                                     "POLYGONS",
                                     "TRIANGLE_STRIPS",
                                     "VERTICES",
                                     "LINES",
                                     "OFFSETS",
                                     "CONNECTIVITY",
                                     "FIELD f 1",
                                     "METADATA",
                                     "POINT_DATA",
                                     "NULL_ARRAY",
                                     "# vtk DataFile Version 3.0",
                                     "# vtk DataFile Version 5.1",
                                     "bit",
                                     "char",
                                     "unsigned_short",
                                     "vtkIdType",
                                     "vtktypeint64",
                                     "float",
                                     "double",
                                     "string"},
                                    {},
                                    ""});
  return OneOf({text, text, MutateBytes});
}

std::vector<std::string> ObjSeeds()
{
  return {MeshToObj(Tetrahedron()),
          "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\ng a\n"
          "f 1/1/1 2/2/1 3/3/1\nf -1 -2 -3\nf 1//1 2//1 4//1\nf 1 2 3 4\nl 1 2\np 1\n"};
}

Mutator ObjMutator()
{
  const Mutator text =
      TextMutator({{"v",  "vn",         "vt",           "f",     "l",     "p",      "g",    "o",
                    "s",  "usemtl a",   "mtllib a.mtl", "1/1/1", "-1",    "-5",     "1//1", "0",
                    "99", "4294967297", "1/2/3/4",      "\\",    "f 1 2", "f 1 1 1"},
                   {},
                   ""});
  return OneOf({text, text, text, MutateBytes});
}

std::vector<std::string> GiftiSeeds()
{
  std::vector<std::string> seeds;
  for (const char* encoding : {"ASCII", "Base64Binary", "GZipBase64Binary"})
  {
    GiftiSpec spec;
    spec.Encoding = encoding;
    spec.Space = seeds.empty() ? "NIFTI_XFORM_SCANNER_ANAT" : spec.Space;
    seeds.push_back(GiftiBytes(spec));
  }
  return seeds;
}

Mutator GiftiMutator()
{
  const Mutator text = TextMutator({{"NIFTI_INTENT_POINTSET",
                                     "NIFTI_INTENT_TRIANGLE",
                                     "NIFTI_TYPE_FLOAT32",
                                     "NIFTI_TYPE_FLOAT64",
                                     "NIFTI_TYPE_INT32",
                                     "NIFTI_XFORM_SCANNER_ANAT",
                                     "ASCII",
                                     "Base64Binary",
                                     "GZipBase64Binary",
                                     "ExternalFileBinary",
                                     "ColumnMajorOrder",
                                     "BigEndian",
                                     "Dim0",
                                     "Dim1",
                                     "DataArray",
                                     "Data",
                                     "MatrixData",
                                     "<!ENTITY a \"b\">",
                                     "&a;",
                                     "<![CDATA["},
                                    {{"<DataArray>", "</DataArray>"}, {"<Data>", "</Data>"}},
                                    ""});
  return OneOf({text, text, text, MutateBytes});
}

Mutator GltfMutator()
{
  const Mutator json = JsonMutator(
      {"asset",      "version",    "scene",      "scenes",        "nodes",
       "children",   "mesh",       "matrix",     "translation",   "rotation",
       "scale",      "skin",       "primitives", "attributes",    "POSITION",
       "indices",    "mode",       "accessors",  "componentType", "count",
       "type",       "VEC3",       "SCALAR",     "sparse",        "bufferViews",
       "byteOffset", "byteLength", "byteStride", "buffers",       "uri",
       "buffer",     "bufferView", "data:,",     "2.0",           "extensionsRequired"});
  return OneOf({json, json, json, MutateBytes});
}

// The heads of the file and of its first chunk, and everything.
Mutator GlbMutator()
{
  const Mutator head = FieldMutator(FieldsFrom(0, 5, 4));
  return OneOf({head, MutateBytes, Behind("BIN", FieldMutator(FieldsFrom(1, 60, 4)))});
}

// Surfaces that are read are also written, which uses every index.
InputReader SurfaceReader(const std::string& fileName)
{
  return FileReader(fileName,
                    [](const std::filesystem::path& file)
                    {
                      const auto surface = ReadSurface(file);
                      WriteSurface(file.parent_path() / "out.ply", surface);
                    });
}

InputReader ModelReader(const std::string& fileName)
{
  return FileReader(fileName, [](const std::filesystem::path& file)
                    { ModelToJson(ReadModel(file), "out.json"); });
}

ModelDocument SomeModel(bool isSurface)
{
  Random random(5);
  const ModelProvenance provenance{"palpate 1", "a.nii", "2", "", {{"degree", "3"}}};
  const RadialModel star(3, RandomNumbers(random, 16, 5.0), Vector3(1, 2, 3));
  if (isSurface)
  {
    return {SurfaceModel::FromModel(star), provenance};
  }
  return {star, provenance};
}

template <typename Write>
std::vector<std::string> ModelSeeds(const Write& write)
{
  return {write(SomeModel(false)), write(SomeModel(true))};
}
} // namespace

std::vector<FuzzTarget> SurfaceTargets()
{
  const Mutator json = JsonMutator({"format", "version", "surface", "degree", "center_mm",
                                    "coefficients_mm", "x", "y", "z", "model", "radial", "surface",
                                    "star-shaped", "parametric", "provenance", "settings"});
  const Mutator coefficients = TextMutator({{}, {{"{", "}"}}, ""});
  return {{"vtp", "a.vtp", VtpSeeds, VtpMutator(), [] { return SurfaceReader("a.vtp"); }},
          {"stl", "a.stl", StlSeeds, StlMutator(), [] { return SurfaceReader("a.stl"); }},
          {"ply", "a.ply", PlySeeds, PlyMutator(), [] { return SurfaceReader("a.ply"); }},
          {"legacy-vtk", "a.vtk", LegacyVtkSeeds, LegacyVtkMutator(),
           [] { return SurfaceReader("a.vtk"); }},
          {"obj", "a.obj", ObjSeeds, ObjMutator(), [] { return SurfaceReader("a.obj"); }},
          {"gltf", "a.gltf", [] { return std::vector<std::string>{MeshToGltf(Tetrahedron())}; },
           GltfMutator(), [] { return SurfaceReader("a.gltf"); }},
          {"glb", "a.glb", [] { return std::vector<std::string>{MeshToGlb(Tetrahedron())}; },
           GlbMutator(), [] { return SurfaceReader("a.glb"); }},
          {"gifti", "a.gii", GiftiSeeds, GiftiMutator(), [] { return SurfaceReader("a.gii"); }},
          {"model-json", "a.json",
           [] {
             return ModelSeeds([](const ModelDocument& model)
                               { return ModelToJson(model, "a.json"); });
           },
           OneOf({json, json, json, MutateBytes}), [] { return ModelReader("a.json"); }},
          {"spharm-pdm", "a.coef",
           []
           {
             return ModelSeeds([](const ModelDocument& model)
                               { return SurfaceToSpharmPdm(model.Surface, "a.coef"); });
           },
           OneOf({coefficients, coefficients, MutateBytes}), [] { return ModelReader("a.coef"); }}};
}
} // namespace palpate::test
