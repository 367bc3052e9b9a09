#ifndef PALPATE_SHAPE_H
#define PALPATE_SHAPE_H

/* Shapes by touch: organs completed from a few points, corrected by pulls at their surface, brought
 * onto each other, and measured along it. A part of palpate.h, whose rules hold here and which
 * includes it. */

#include "palpate.h"

#ifdef __cplusplus
extern "C"
{
#endif

  /* Radial, completed from `count` touched points (x, y, z of each) of a standard deviation `sigma`
   * (mm). May be NULL: `normals` (0 for none), `strokes` (points of one number above 0 share an
   * offset), `outside` (not 0: the organ does not reach that far), `prior` (a file of palpate
   * cohort --prior), `center` (near the organ's), `deviations` (mm, of the points of
   * palpate_model_mesh of frequency 8), `next` (6 places to touch next). */
  palpate_model* palpate_complete(const double* points, const double* normals,
                                  const int32_t* strokes, const uint8_t* outside, size_t count,
                                  const char* prior, double sigma, const double center[3],
                                  double* deviations, double* next, palpate_error* error);
  /* The same with a prior of radial or of surface models, and the model of its kind. `known`, which
   * may be NULL, is the other organ of the patient that a prior of palpate cohort --known relates
   * to; then `center` is not read. With a prior of surface models `normals` have to point
   * outwards. */
  palpate_model* palpate_complete_organ(const double* points, const double* normals,
                                        const int32_t* strokes, const uint8_t* outside,
                                        size_t count, const char* prior, double sigma,
                                        const double center[3], const palpate_model* known,
                                        double* deviations, double* next, palpate_error* error);

  /* A mask or a model under correction: a function of the start and the list of steps, each of
   * which can be undone. */
  typedef struct palpate_correction palpate_correction;

  typedef struct palpate_pull
  {
    double place[3];     /* mm: the nearest point of the surface as it is now is pulled */
    double displacement; /* mm, outwards: along its normal, or a radial model's ray */
    int has_target;      /* else the next is not read */
    double target[3];    /* mm: where that point goes instead; of a radial model, along its ray */
    double width;        /* mm: standard deviation of the Gaussian along the surface */
    double second_width; /* mm: then the mean of two Gaussians; 0 for one */
  } palpate_pull;

  /* Of a model; the points of its surface are those of palpate_model_mesh of frequency 24. */
  palpate_correction* palpate_correction_of_model(const palpate_model* model, palpate_error* error);
  /* Of a mask, as palpate_model_fit_mask has it. Pulls add no voxel where `barrier`, of the same
   * size, is not 0, such as that of a neighbour; NULL for none. */
  palpate_correction* palpate_correction_of_mask(const uint8_t* inside, const uint8_t* barrier,
                                                 const int size[3], const double origin[3],
                                                 const double spacing[3], const double axes[9],
                                                 palpate_error* error);
  void palpate_correction_free(palpate_correction* correction);

  /* Former pulls' places stay where they are, but for those within half the width. */
  int palpate_correction_pull(palpate_correction* correction, const palpate_pull* pull,
                              palpate_error* error);
  /* The displacements (mm, x, y, z of each point of the surface) if this pull were added. */
  int palpate_correction_preview(palpate_correction* correction, const palpate_pull* pull,
                                 double* displacements, palpate_error* error);
  /* Plain edits, of masks only: all but the largest part removed; cavities filled; the surface
   * smoothed by a Gaussian (mm), its size kept; what lies beyond a plane, where its normal points
   * to, removed. */
  int palpate_correction_remove_islands(palpate_correction* correction, palpate_error* error);
  int palpate_correction_fill(palpate_correction* correction, palpate_error* error);
  int palpate_correction_smooth(palpate_correction* correction, double deviation,
                                palpate_error* error);
  int palpate_correction_cut(palpate_correction* correction, const double point[3],
                             const double normal[3], palpate_error* error);
  /* Removes the last step; 0 if there is none. */
  int palpate_correction_undo(palpate_correction* correction);

  /* The surface before the pulls since the last edit, its normals (a radial model's rays), and how
   * far the pulls moved its points. With NULL arrays only the counts, which an edit changes. */
  int palpate_correction_surface(palpate_correction* correction, size_t* point_count,
                                 size_t* triangle_count, double* points, double* normals,
                                 double* displacements, int32_t* triangles, palpate_error* error);
  /* The corrected mask: a byte for each voxel, 1 inside. */
  int palpate_correction_mask(palpate_correction* correction, uint8_t* inside,
                              palpate_error* error);
  /* The corrected model, of degree 20 or that of the start if it is higher. */
  palpate_model* palpate_correction_model(palpate_correction* correction, palpate_error* error);

  /* Brings a body onto another one, by points of its surface, as palpate_register_points. A `start`
   * of NULL brings their centroids onto each other. Masks are best given as their shapes. */
  int palpate_register_bodies(const palpate_compared* moving, const palpate_compared* fixed,
                              int kind, double noise, const double start[16],
                              palpate_registration* found, palpate_error* error);

  /* Lengths along a surface, mm. Several threads may ask one object. */
  typedef struct palpate_geodesics palpate_geodesics;

  typedef struct palpate_geodesic
  {
    double from[3]; /* mm: the surface's points that are nearest to those asked for */
    double to[3];
    double along;       /* mm: the shortest path */
    double straight;    /* mm: through space */
    double uncertainty; /* mm, of `along`; NaN of triangles */
  } palpate_geodesic;

  /* On a model itself; along the triangles of a body's surface. */
  palpate_geodesics* palpate_geodesics_of_model(const palpate_model* model, palpate_error* error);
  palpate_geodesics* palpate_geodesics_of_body(const palpate_compared* body, palpate_error* error);
  void palpate_geodesics_free(palpate_geodesics* surface);
  /* `path_count` gets the number of the path's points, of which `path` (x, y, z of each; NULL for
   * none) gets the first `capacity`. Fails if no path connects the two places. */
  int palpate_geodesics_find(const palpate_geodesics* surface, const double from[3],
                             const double to[3], palpate_geodesic* found, double* path,
                             size_t capacity, size_t* path_count, palpate_error* error);
  /* The surface: a body's, or a model drawn finely; and the length from one of its points to each
   * (infinite: not connected). With NULL arrays only the counts. */
  int palpate_geodesics_map(const palpate_geodesics* surface, const double from[3],
                            size_t* point_count, size_t* triangle_count, double* points,
                            int32_t* triangles, double* distances, palpate_error* error);

#ifdef __cplusplus
}
#endif

#endif
