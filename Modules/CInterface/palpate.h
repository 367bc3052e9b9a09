#ifndef PALPATE_H
#define PALPATE_H

/* Palpate's kernels for C99 and for languages that call C: models in spherical harmonics, fields,
 * scenes, what a tool feels there, and haptic devices.
 *
 * Lengths are mm, forces N, stiffness N/mm, times s; the frame is the patient's LPS. Points and
 * vectors are three doubles. Handles are opaque; each is freed by the function named _free, which
 * accepts NULL; what was made from a handle does not need it any longer. No function throws or
 * prints.
 *
 * A function that can fail returns NULL or 0, leaves its outputs alone, and writes one sentence
 * into `error`, unless that is NULL. Functions without `error` cannot fail. An argument that is
 * needed and NULL, and a count or a size that no machine holds, are such failures; a count that is
 * wrong but smaller cannot be noticed. Without its arguments a function that has no `error` does
 * nothing and returns 0, NULL or an empty text.
 *
 * Handles may be used by several threads at once where they are const, else by one at a time. */

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C"
{
#endif

#define PALPATE_API_VERSION 1

  typedef struct palpate_error
  {
    char text[512]; /* UTF-8, ends with 0 */
  } palpate_error;

  typedef struct palpate_model palpate_model;
  typedef struct palpate_field palpate_field;
  typedef struct palpate_scene palpate_scene;
  typedef struct palpate_tracker palpate_tracker;
  typedef struct palpate_compared palpate_compared;
  typedef struct palpate_case palpate_case;
  typedef struct palpate_check_group palpate_check_group;
  typedef struct palpate_checked palpate_checked;
  typedef struct palpate_design palpate_design;
  typedef struct palpate_session palpate_session;

  /* Of the library, "major.minor.patch"; and its PALPATE_API_VERSION, which changes when a program
   * has to be compiled again. */
  const char* palpate_version(void);
  int palpate_api_version(void);

  /* Models of organs in spherical harmonics: radial models (a radius around a centre) and surface
   * models (three coordinates). */
  /* Radial, of (degree + 1)^2 coefficients (mm): real, orthonormal, no Condon-Shortley phase,
   * at l (l + 1) + m. */
  palpate_model* palpate_model_create(int degree, const double* coefficients,
                                      const double center[3], palpate_error* error);
  /* A surface model, of 3 (degree + 1)^2 coefficients: those of x, then y, then z. */
  palpate_model* palpate_model_create_surface(int degree, const double* coefficients,
                                              palpate_error* error);
  /* The same by its former name. Deprecated. */
  palpate_model* palpate_model_create_parametric(int degree, const double* coefficients,
                                                 palpate_error* error);
  /* Radial, fitted by least squares to `count` points of a surface (x, y, z of each). */
  palpate_model* palpate_model_fit(const double* points, size_t count, const double center[3],
                                   int degree, palpate_error* error);
  /* Fitted to a mask: size[0] size[1] size[2] bytes, i fastest, inside where not 0. Row i of `axes`
   * is the unit vector of the grid's axis i. A surface model, or a radial one around the centroid,
   * sampled along 4,002 directions. Parts that are far from the largest are left out. Refuses masks
   * with a cavity of more than 65 mm3, masks of which parts that are left out, handles and cavities
   * are more than 2 % of the volume, and such as are not star-shaped where they have to be. */
  palpate_model* palpate_model_fit_mask(const uint8_t* inside, const int size[3],
                                        const double origin[3], const double spacing[3],
                                        const double axes[9], int degree, int is_radial,
                                        palpate_error* error);
  /* What that changed: "1 handle cut, 0.8 % of the volume"; empty if nothing, and for models that
   * were not fitted to a mask. Valid as long as the model. */
  const char* palpate_model_changes(const palpate_model* model);
  /* Palpate's .json, with its elasticity if it has one, or SPHARM-PDM's .coef. Written: .csv too.
   */
  palpate_model* palpate_model_read(const char* path, palpate_error* error);
  int palpate_model_write(const palpate_model* model, const char* path, palpate_error* error);
  void palpate_model_free(palpate_model* model);

  int palpate_model_degree(const palpate_model* model);
  int palpate_model_is_radial(const palpate_model* model);      /* else it is a surface model */
  int palpate_model_is_star_shaped(const palpate_model* model); /* the same; deprecated */
  int palpate_model_yields(const palpate_model* model);         /* whether it has an elasticity */
  /* Of all coefficients: (degree + 1)^2, or three times that; a surface model's are those of x,
   * then y, then z. Copies at most `capacity` of them, and returns how many there are. */
  size_t palpate_model_coefficients(const palpate_model* model, double* coefficients,
                                    size_t capacity);
  void palpate_model_center(const palpate_model* model, double center[3]);
  /* The surface's point along a direction from the centre, or at a parameter: not zero, of any
   * length. The unit normal points outwards. */
  int palpate_model_point(const palpate_model* model, const double direction[3], double point[3],
                          double normal[3], palpate_error* error);

  /* Where evaluations go: arrays of the caller with an entry for each direction; vectors are three
   * numbers. NULL leaves one out. */
  typedef struct palpate_evaluation
  {
    double* points;               /* mm */
    double* normals;              /* unit, outwards */
    double* radii;                /* mm; of radial models */
    double* gradients;            /* of the radius over the unit sphere, mm/rad; likewise */
    double* mean_curvatures;      /* 1/mm; a sphere's are positive */
    double* gaussian_curvatures;  /* 1/mm^2 */
    double* principal_curvatures; /* two numbers, the larger first, 1/mm */
    double* principal_directions; /* two unit tangents, in the same order */
  } palpate_evaluation;
  /* palpate_model_point for `count` directions (x, y, z of each) at once. */
  int palpate_model_evaluate(const palpate_model* model, const double* directions, size_t count,
                             const palpate_evaluation* results, palpate_error* error);

  typedef struct palpate_body
  {
    double volume; /* mm^3 */
    double area;   /* mm^2 */
    double centroid[3];
    double semi_axes[3]; /* mm, the longest first: of the ellipsoid with the same volume and, up to
                          * a factor, the same second moments */
    double axes[9];      /* row i: the unit vector of semi-axis i */
  } palpate_body;
  int palpate_model_body(const palpate_model* model, palpate_body* body, palpate_error* error);
  /* The power of each degree (sum of its squared coefficients, mm^2): degree + 1 numbers. */
  int palpate_model_spectrum(const palpate_model* model, double* spectrum, palpate_error* error);
  /* mm^3 and mm^2. */
  int palpate_model_measure(const palpate_model* model, double* volume, double* area,
                            palpate_error* error);
  /* The surface's point nearest to `query`, and the distance from there, negative inside. A model's
   * first call prepares the search, which may take seconds for a surface model. Several threads
   * may call it at once. */
  int palpate_model_nearest(palpate_model* model, const double query[3], double point[3],
                            double normal[3], double* distance, palpate_error* error);
  /* A closed mesh: 10 frequency^2 + 2 points and their normals (x, y, z of each; normals may be
   * NULL), and 20 frequency^2 triangles of three indices, counter-clockwise from outside. */
  size_t palpate_mesh_point_count(int frequency);
  size_t palpate_mesh_triangle_count(int frequency);
  int palpate_model_mesh(const palpate_model* model, int frequency, double* points, double* normals,
                         int32_t* triangles, palpate_error* error);

  /* Comparisons of two bodies, each a mask, a closed or open mesh, or a model; on any grid. */
  /* A mask, as palpate_model_fit_mask has it: its surface lies half way between the centres of
   * voxels inside and outside. */
  palpate_compared* palpate_compared_of_mask(const uint8_t* inside, const int size[3],
                                             const double origin[3], const double spacing[3],
                                             const double axes[9], palpate_error* error);
  palpate_compared* palpate_compared_of_mesh(const double* points, size_t point_count,
                                             const int32_t* triangles, size_t triangle_count,
                                             palpate_error* error);
  palpate_compared* palpate_compared_of_model(const palpate_model* model, palpate_error* error);
  void palpate_compared_free(palpate_compared* body);
  /* The surface at whose points distances are taken: it may have more points than were given. */
  size_t palpate_compared_point_count(const palpate_compared* body);
  size_t palpate_compared_triangle_count(const palpate_compared* body);
  void palpate_compared_surface(const palpate_compared* body, double* points, int32_t* triangles);
  /* mm^3, NaN of an open mesh, and mm^2. */
  void palpate_compared_measure(const palpate_compared* body, double* volume, double* area);
  /* A body's mirror image at the sagittal plane x = 0, turned (rad) and, at its centroid, shifted
   * (mm) onto another body: for asymmetry. Masks are best given as their shapes. */
  palpate_compared* palpate_compared_mirror(const palpate_compared* body,
                                            const palpate_compared* onto, double* turn,
                                            double shift[3], palpate_error* error);

  /* mm; over a surface's area. */
  typedef struct palpate_distances
  {
    double mean;
    double rms;
    double percentile95;
    double maximum;
    double
        signed_mean; /* negative inside the other body; NaN if that is open, or of both together */
  } palpate_distances;

  /* NaN: does not exist for an open mesh. */
  typedef struct palpate_comparison
  {
    double dice;
    double jaccard;
    double volumes[2];              /* mm^3, of the first and the reference */
    double areas[2];                /* mm^2 */
    palpate_distances both;         /* each direction with half of the weight */
    palpate_distances to_reference; /* of the first surface's points from the reference */
    palpate_distances to_first;
    double hausdorff95;  /* the larger of the two directions' 95th percentiles */
    double side_bias[6]; /* mean signed distance of the first surface on the left, right, posterior,
                          * anterior, superior and inferior side of the reference's centroid */
  } palpate_comparison;

  /* Compares a body with a reference. `surface_dice` gets a number for each tolerance (mm); the
   * arrays of distances, of which any may be NULL, one for each point of the surfaces. */
  int palpate_compare(const palpate_compared* first, const palpate_compared* reference,
                      const double* tolerances, size_t tolerance_count,
                      palpate_comparison* comparison, double* surface_dice, double* first_distances,
                      double* reference_distances, palpate_error* error);

  /* Relations of two closed bodies, and the shape of one. */
  /* A mask as the shape that its voxels were drawn from, closer to the organ than their steps. */
  palpate_compared* palpate_compared_of_mask_shape(const uint8_t* inside, const int size[3],
                                                   const double origin[3], const double spacing[3],
                                                   const double axes[9], palpate_error* error);

  /* The shape features of the Image Biomarker Standardisation Initiative, in mm, mm^2 and mm^3. The
   * Initiative's numbers are those of palpate_compared_of_mask. */
  typedef struct palpate_shape
  {
    double volume;                   /* RNU0 */
    double area;                     /* C0JK */
    double surface_to_volume_ratio;  /* 2PR5 */
    double compactness_1;            /* SKGS */
    double compactness_2;            /* BQWJ */
    double spherical_disproportion;  /* KRCK */
    double sphericity;               /* QCFX */
    double asphericity;              /* 25C7 */
    double maximum_diameter;         /* L0JK */
    double major_axis_length;        /* TDIC: four standard deviations along a principal axis */
    double minor_axis_length;        /* P9VJ */
    double least_axis_length;        /* 7J51 */
    double elongation;               /* Q3CK */
    double flatness;                 /* N17B */
    double volume_density_box;       /* PBX1: over the box along the axes of the world */
    double area_density_box;         /* R59B */
    double volume_density_ellipsoid; /* 6BDE: over the approximate enclosing ellipsoid */
    double area_density_ellipsoid;   /* RDD2 */
    double volume_density_hull;      /* R3ER: over the convex hull */
    double area_density_hull;        /* 7T7F */
    double centroid[3];
    double axes[9]; /* unit vectors, one after the other, the longest axis first */
  } palpate_shape;
  int palpate_compared_shape(const palpate_compared* body, palpate_shape* shape,
                             palpate_error* error);
  /* The diameter (mm) of the largest ball that touches the surface at each of its points from
   * inside. */
  int palpate_compared_thickness(const palpate_compared* body, double* thickness,
                                 palpate_error* error);
  /* The length of the inward normal there up to the opposite side; NaN if there is none. */
  int palpate_compared_ray_thickness(const palpate_compared* body, double* thickness,
                                     palpate_error* error);

  /* A section of a tube, perpendicular to its axis. */
  typedef struct palpate_section
  {
    double along; /* mm of the axis, from its first end */
    double center[3];
    double axis[3];
    double area;  /* mm^2 */
    double least; /* mm: its least and its largest width */
    double largest;
  } palpate_section;
  /* The calibre of a body that is one long tube: the length (mm) of its axis, and its sections, of
   * which at most `capacity` are copied. Returns how many there are. */
  size_t palpate_compared_calibre(const palpate_compared* body, palpate_section* sections,
                                  size_t capacity, double* length, palpate_error* error);

  typedef struct palpate_motion
  {
    double turn;     /* rad */
    double shift[3]; /* mm, of the centroid */
    double rest;     /* mm: RMS distance of the surfaces after turn and shift */
  } palpate_motion;
  /* How a body moved from one place to another. Landmarks (x, y, z of each, mm) on the first move
   * with it. Masks are best given as their shapes. */
  int palpate_compared_motion(const palpate_compared* from, const palpate_compared* to,
                              const double* landmarks, size_t landmark_count,
                              palpate_motion* motion, double* moved, palpate_error* error);

  typedef struct palpate_relation
  {
    int kind;              /* the first is 0 apart from, 1 overlapping, 2 in, 3 around the other */
    double distance;       /* mm; 0 unless they are apart */
    double wall;           /* mm between the surfaces, also of bodies in each other */
    double first_point[3]; /* where they are nearest */
    double second_point[3];
    double shared_volume;    /* mm^3 */
    double contact_areas[2]; /* mm^2 of each surface within the contact distance of the other one */
    double offset[3];        /* mm, from the first centroid to the second */
    double axes_angle;       /* degrees between the longest axes, 0 to 90 */
  } palpate_relation;
  /* `contact` and the ascending `margins` are mm. `near_areas` and `near_volumes` get two numbers
   * for each margin: the share of the first body's surface or volume that lies in the second or
   * within the margin of it, and of the second body's. */
  int palpate_relate(const palpate_compared* first, const palpate_compared* second, double contact,
                     const double* margins, size_t margin_count, palpate_relation* relation,
                     double* near_areas, double* near_volumes, palpate_error* error);

  /* Registration: points brought to where they belong. */
  typedef struct palpate_registration
  {
    double map[16];    /* of the moving points: a matrix, row after row */
    double rms;        /* mm, of what remains */
    double turn_error; /* predicted standard deviations, rad and mm; of affine maps NaN */
    double shift_error;
    double median; /* mm; of landmarks NaN */
    int has_converged;
  } palpate_registration;
  /* `kind` of the map: 0 rigid, 1 similarity, 2 affine. `noise` is the standard deviation of a
   * coordinate (mm); 0: judged by what remains. Landmarks are in the order of their partners;
   * `residuals` (mm) and `weights` (near 0: a wrong pair) get a number for each pair. */
  int palpate_register_landmarks(const double* moving, const double* fixed, size_t count, int kind,
                                 double noise, palpate_registration* found, double* residuals,
                                 double* weights, palpate_error* error);
  /* Points onto a surface, from a start near it; NULL: from where they are. */
  int palpate_register_points(const double* points, size_t count, const palpate_compared* surface,
                              int kind, double noise, const double start[16],
                              palpate_registration* found, palpate_error* error);

  /* Checks: whether masks can be believed. They use all processors. */
  /* Measures the structures of one patient: the labels `values` of a grid of size[0] size[1]
   * size[2] numbers, i fastest, with their names ("": "label N"), or masks that may overlap. An
   * `axes` of NULL is x, y and z, of which nobody says that they are the patient's: sides are then
   * judged by pairs of names alone. */
  palpate_case* palpate_case_of_labels(const int32_t* labels, const int size[3],
                                       const double origin[3], const double spacing[3],
                                       const double axes[9], size_t structure_count,
                                       const int32_t* values, const char* const* names,
                                       palpate_error* error);
  palpate_case* palpate_case_of_masks(const uint8_t* const* masks, const int size[3],
                                      const double origin[3], const double spacing[3],
                                      const double axes[9], size_t structure_count,
                                      const char* const* names, palpate_error* error);
  void palpate_case_free(palpate_case* one);
  /* What clean cases look like, twenty of a structure at least; files are those of `palpate
   * check`. */
  palpate_check_group* palpate_check_group_create(const palpate_case* const* cases,
                                                  size_t case_count, palpate_error* error);
  palpate_check_group* palpate_check_group_read(const char* path, palpate_error* error);
  int palpate_check_group_write(const palpate_check_group* group, const char* path,
                                palpate_error* error);
  void palpate_check_group_free(palpate_check_group* group);
  /* The least rate of false alarms that it can hold, 0 to 1. */
  double palpate_check_group_least_rate(const palpate_check_group* group);
  /* Why the k-th odd case, with its place among those given, does not count; NULL if there is no
   * k-th. Not in files. */
  const char* palpate_check_group_dropped(const palpate_check_group* group, size_t k,
                                          size_t* place);
  /* Judges a case against a group at a rate of false alarms of the whole case (0 to 1), or by fixed
   * limits if `group` is NULL. */
  palpate_checked* palpate_case_check(const palpate_case* one, const palpate_check_group* group,
                                      double false_alarms, palpate_error* error);
  void palpate_checked_free(palpate_checked* checked);

  /* Texts are valid as long as `checked`. */
  typedef struct palpate_verdict
  {
    const char* name;
    const char* sentence; /* what is suspicious, without the name */
    const char* rule;     /* that gave the verdict; empty of a plausible structure */
    int verdict;          /* 0 plausible, 1 look here, 2 implausible */
    double place[3];      /* mm; NaN of a plausible structure */
    double p;             /* of a clean case to look as bad; NaN without the group */
    double volume;        /* mm^3 */
  } palpate_verdict;
  typedef struct palpate_rule
  {
    const char* key;
    double value;
    double place[3]; /* mm */
    double p;        /* of a clean structure to have as large a value; NaN without the group */
    int is_alarm;    /* whether this rule alone gives a verdict */
  } palpate_rule;
  /* Of a structure, in the order given; the last may be "all structures". 0 if there is none. */
  int palpate_checked_verdict(const palpate_checked* checked, size_t structure,
                              palpate_verdict* found);
  int palpate_checked_rule(const palpate_checked* checked, size_t structure, size_t rule,
                           palpate_rule* found);

  /* Statistics: linear models of many outcomes on covariates. */
  /* `formula` is in R's notation: "~ age + log(psa) + a * b". `values` has the text of each case,
   * column after column; empty or NA is missing, and a column with a word is a factor. Cases
   * without a value of a used column are left out. `references` are levels of factors,
   * "COLUMN=LEVEL". */
  palpate_design* palpate_design_create(const char* formula, size_t case_count, size_t column_count,
                                        const char* const* names, const char* const* values,
                                        size_t reference_count, const char* const* references,
                                        palpate_error* error);
  void palpate_design_free(palpate_design* design);
  size_t palpate_design_case_count(const palpate_design* design); /* those that are not left out */
  size_t palpate_design_column_count(const palpate_design* design);
  size_t palpate_design_term_count(const palpate_design* design);
  /* As R names it: "(Intercept)", "groupb". NULL if there is no such column. */
  const char* palpate_design_column_name(const palpate_design* design, size_t column);

  /* The columns of a term. A part of an interaction is not to be tested by itself. */
  typedef struct palpate_term
  {
    const char* name;
    size_t first_column;
    size_t column_count;
    int is_tested;
  } palpate_term;
  /* 0 if there is no such term. */
  int palpate_design_term(const palpate_design* design, size_t term, palpate_term* found);
  /* The indices of the cases that are not left out; the matrix, one row for each of them. */
  void palpate_design_matrix(const palpate_design* design, size_t* cases, double* matrix);

  /* Outcomes: one row per case that was given, `outcome_count` numbers each; rows of cases that are
   * left out are not read. Results: one row per column of the design. */
  int palpate_design_fit(const palpate_design* design, const double* outcomes, size_t outcome_count,
                         double confidence, double* coefficients, double* errors,
                         double* half_widths, palpate_error* error);
  /* F of a term given all others, for each outcome; its p and partial R^2. NULL leaves one out. */
  int palpate_design_test(const palpate_design* design, size_t term, const double* outcomes,
                          size_t outcome_count, double* f, double* p, double* partial_r2,
                          palpate_error* error);

  /* Where a mixed model's numbers go: rows have a number for each outcome, NaN where the outcome
   * does not vary. NULL leaves one out. */
  typedef struct palpate_mixed
  {
    double* coefficients; /* one row per column of the design, also of the next two */
    double* errors;       /* with Kenward and Roger's correction */
    double* half_widths;
    double* f; /* one row per term, of Kenward and Roger's test, also of the next three */
    double* numerator_degrees;
    double* denominator_degrees;
    double* p;
    double* criterion;          /* one row: -2 log restricted likelihood */
    double* residual_variance;  /* one row */
    double* subject_covariance; /* three rows: of intercepts, with slopes, of slopes */
    double* is_singular;        /* one row: 0 or 1 */
  } palpate_mixed;
  /* A random intercept of each subject and, unless `times` is NULL, a slope, by restricted maximum
   * likelihood. `subjects` (any numbers) and `times` have one per case that was given. */
  int palpate_design_fit_mixed(const palpate_design* design, const int32_t* subjects,
                               const double* times, const double* outcomes, size_t outcome_count,
                               double confidence, const palpate_mixed* results,
                               palpate_error* error);

  typedef struct palpate_statistic
  {
    double value;
    double f;
    double numerator_degrees;
    double denominator_degrees;
    double p;
  } palpate_statistic;
  typedef struct palpate_multivariate
  {
    palpate_statistic pillai;
    palpate_statistic wilks;
    palpate_statistic hotelling_lawley;
    palpate_statistic roy;
  } palpate_multivariate;
  /* All outcomes together. */
  int palpate_design_test_together(const palpate_design* design, size_t term,
                                   const double* outcomes, size_t outcome_count,
                                   palpate_multivariate* found, palpate_error* error);
  /* The outcomes are of points of a surface, with their areas (mm^2) and triangles. By permutation
   * of the residuals under the other terms: t of a term with one column, else the root of F; p of
   * each point; p corrected for all points by the largest statistic and by threshold-free cluster
   * enhancement; F of the whole surface and its p. NULL leaves out one of the numbers of
   * each point. Uses all processors; the results depend on the seed alone. */
  int palpate_design_permute(const palpate_design* design, size_t term, const double* outcomes,
                             size_t point_count, const double* areas, const int32_t* triangles,
                             size_t triangle_count, int permutations, uint64_t seed,
                             double* statistic, double* p, double* family_p, double* enhanced_p,
                             double* whole_f, double* whole_p, palpate_error* error);
  /* A model at the 10 frequency^2 + 2 directions of an icosahedron: points relative to its centre,
   * normals, areas, 20 frequency^2 triangles; and how far each point moves along its normal (mm)
   * per mm of each coefficient, one row per point. */
  int palpate_model_displacement(const palpate_model* model, int frequency, double* points,
                                 double* normals, double* areas, int32_t* triangles,
                                 double* per_coefficient, palpate_error* error);

  typedef struct palpate_asymmetry
  {
    double squares[3]; /* mm^2: of individuals, sides (directional), both (fluctuating) */
    double degrees[3];
    double f; /* of the sides */
    double p;
    double* individuals; /* mm, RMS of each; this and the next, which have a number per point of
                          * the mean at this frequency, may be NULL */
    double* mean;        /* left minus right along the mean's normals, mm */
    double* deviations;  /* mm */
    double* statistic;   /* paired t */
    double* point_p;
    double* family_p; /* corrected for all points */
    double* points;   /* x, y, z of each */
  } palpate_asymmetry;
  /* Procrustes analysis of variance of left models and mirrored right ones, or, if `right` is NULL,
   * of models and their own mirror images; p by `flips` random exchanges of sides. All are moved to
   * the origin, and with `turns_to_mean` turned to their common mean. */
  int palpate_find_asymmetry(const palpate_model* const* left, const palpate_model* const* right,
                             size_t count, int turns_to_mean, int frequency, int flips,
                             uint64_t seed, palpate_asymmetry* found, palpate_error* error);

  /* Fields: volumes as they are touched, between voxels. */

  /* `values` has size[0] size[1] size[2] numbers, i fastest; row i of `axes` is the unit vector of
   * the grid's axis i, and the axes are right-handed. The object is where values are at least
   * `iso`. */
  palpate_field* palpate_field_create(const int size[3], const double origin[3],
                                      const double spacing[3], const double axes[9],
                                      const float* values, double iso, palpate_error* error);
  void palpate_field_free(palpate_field* field);
  int palpate_field_is_inside(const palpate_field* field, const double point[3]);

  /* Scenes: the structures that can be touched, and the tool. */

  typedef struct palpate_law
  {
    double stiffness;       /* N/mm, up to 100; a structure that yields has its own */
    double damping;         /* N s/mm, up to 10 */
    double static_friction; /* coefficients: 0 <= dynamic <= static <= 10 */
    double dynamic_friction;
  } palpate_law;

  palpate_scene* palpate_scene_create(void);
  void palpate_scene_free(palpate_scene* scene);
  /* Adds a structure. Its id, above 0 and of no other structure, is reported by contacts, and lets
   * it carry on in a later scene. A model that yields is felt as such. */
  int palpate_scene_add_model(palpate_scene* scene, int id, const palpate_model* model,
                              const palpate_law* law, palpate_error* error);
  int palpate_scene_add_field(palpate_scene* scene, int id, const palpate_field* field,
                              const palpate_law* law, palpate_error* error);
  /* A closed triangle mesh. */
  int palpate_scene_add_mesh(palpate_scene* scene, int id, const double* points, size_t point_count,
                             const int32_t* triangles, size_t triangle_count,
                             const palpate_law* law, palpate_error* error);
  /* A sphere; 1 mm unless set. 0 is a point; up to 100 mm. */
  int palpate_scene_set_tool_radius(palpate_scene* scene, double radius, palpate_error* error);
  /* Where the middle of the device's workspace is, and mm of the scene for one of the hand, 0.001
   * to 1,000. Without it, a session begins with the whole scene in reach. */
  int palpate_scene_set_workspace(palpate_scene* scene, const double center[3], double scale,
                                  palpate_error* error);

  /* Tracking: a tool in a scene without a device, for a program with a loop of its own. */

  typedef struct palpate_contact
  {
    int id;           /* of the structure touched most deeply; 0: none */
    double proxy[3];  /* where the tool would be if it could not enter that structure */
    double normal[3]; /* unit, out of it */
    double depth;     /* from the probe to the proxy */
    double force[3];  /* of all structures, without damping */
  } palpate_contact;

  palpate_tracker* palpate_tracker_create(const palpate_scene* scene, palpate_error* error);
  void palpate_tracker_free(palpate_tracker* tracker);
  /* Moves the tool there from its last place. Neither allocates nor locks. Returns 0, with no
   * contact, for a place that is not finite. */
  int palpate_tracker_follow(palpate_tracker* tracker, const double probe[3],
                             palpate_contact* contact);
  /* Forgets the last place: the next one is reached from outside. */
  void palpate_tracker_release(palpate_tracker* tracker);

  /* Sessions: a device and a servo thread. Forces are limited, faded in, and off after any
   * fault. */

  typedef struct palpate_state
  {
    int64_t time;     /* ns of the machine's steady clock, at the tick's begin */
    uint64_t tick;    /* its number */
    double probe[3];  /* the hand */
    double proxy[3];  /* where the tool is shown */
    double force[3];  /* sent, in the scene's axes */
    uint32_t buttons; /* one bit each */
    int has_sample;   /* whether the device has told its position */
    int id;           /* of the structure touched most deeply; 0: none */
    double depth;
    double patch;    /* radius of the contact with a structure that yields; else 0 */
    int is_estimate; /* linear elasticity does not hold there */
    int is_armed;    /* whether forces are on; they are off after a fault */
    int is_ramping;  /* whether they are still fading in */
  } palpate_state;

  /* Opens a device by its name: "simulated", "falcon". May take seconds. End sessions in the thread
   * of main. */
  palpate_session* palpate_session_open(const char* device, palpate_error* error);
  /* 0 N, then closes the device. */
  void palpate_session_free(palpate_session* session);
  /* Starts to render a scene at 1 kHz, or changes it: forces fade in, or with `is_continuing`
   * structures with the same id carry on. */
  int palpate_session_show(palpate_session* session, const palpate_scene* scene, int is_continuing,
                           palpate_error* error);
  /* The newest tick; 0 before the first scene. Call it ten times a second or more often. */
  int palpate_session_read(palpate_session* session, palpate_state* state);
  /* Why forces are off and what to do, as one message; empty while they are on. Valid until the
   * next call for this session. */
  const char* palpate_session_problem(palpate_session* session);
  /* 0 N from the next tick on, until forces are allowed again, which also ends a fault. */
  void palpate_session_stop_force(palpate_session* session);
  void palpate_session_allow_force(palpate_session* session);
  /* Leads a simulated hand to a place of the scene; returns 0, without effect, for a real one. */
  int palpate_session_lead_hand(palpate_session* session, const double place[3]);

#ifdef __cplusplus
}
#endif

#include "palpate_shape.h"

#endif
