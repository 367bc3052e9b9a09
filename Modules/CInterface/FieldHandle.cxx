#include "FieldHandle.h"

#include "ErrorText.h"
#include "FieldBuilder.h"
#include "GridArgument.h"

using namespace palpate;

palpate_field* palpate_field_create(const int size[3], const double origin[3],
                                    const double spacing[3], const double axes[9],
                                    const float* values, double iso, palpate_error* error)
{
  return Guarded(error,
                 {{size, "size"},
                  {origin, "origin"},
                  {spacing, "spacing"},
                  {axes, "axes"},
                  {values, "values"}},
                 [&]() -> palpate_field*
                 {
                   Matrix3 direction;
                   direction << VectorOf(axes), VectorOf(axes + 3), VectorOf(axes + 6);
                   const FieldGrid grid({size[0], size[1], size[2]}, VectorOf(origin),
                                        VectorOf(spacing), direction);
                   if (Told(grid.Check(), error) == 0)
                   {
                     return nullptr;
                   }
                   CheckVoxels(size);
                   FieldBuilder builder(grid);
                   const int channel = builder.AddChannel(SamplesOfGrid(values, grid));
                   builder.AddMaterial({channel, iso, FieldSense::AtLeast});
                   std::shared_ptr<const ScalarField> field;
                   return Told(builder.Build(field), error) != 0
                              ? new palpate_field{field, FieldSampler(field)}
                              : nullptr;
                 });
}

void palpate_field_free(palpate_field* field)
{
  delete field;
}

int palpate_field_is_inside(const palpate_field* field, const double point[3])
{
  return field != nullptr && point != nullptr && field->Sampler.IsInsideWorld(0, VectorOf(point))
             ? 1
             : 0;
}
