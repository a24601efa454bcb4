#ifndef IDIOPHONE_VOICES_H
#define IDIOPHONE_VOICES_H
/* Bodies that sound in a game engine, for C and for languages that call C (docs/use/engines.md). The C++ header
   idiophone/instruments/engines/engine_stage.hpp says what each number means. SPDX-License-Identifier: MIT OR
   GPL-3.0-or-later

   Each function that can fail returns an idiophone_status. idiophone_message() then says why. What it makes is null
   then. On machines of 64 bits, structures have no padding. Numbers are in SI units. */

/* NOLINTBEGIN(modernize-deprecated-headers,modernize-use-using): this is C, too */
#include <stdint.h>

#if defined(__GNUC__)
#define IDIOPHONE_API __attribute__((visibility("default")))
#else
#define IDIOPHONE_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

typedef int32_t idiophone_status;
#define IDIOPHONE_OK 0
#define IDIOPHONE_BAD_ARGUMENT 1 /* a null pointer, or a number out of its range */
#define IDIOPHONE_BAD_FILE 2     /* it can't be read, is damaged, or is no voice or proxy file */
#define IDIOPHONE_NO_MEMORY 3

#define IDIOPHONE_NOBODY (-1)

typedef enum { IDIOPHONE_BEGIN = 0, IDIOPHONE_PERSIST = 1, IDIOPHONE_END = 2 } idiophone_phase;

typedef struct idiophone_map idiophone_map;     /* a sound map that bodies share */
typedef struct idiophone_proxy idiophone_proxy; /* a mass-spring proxy that bodies share */
typedef struct idiophone_stage idiophone_stage; /* bodies that sound together */

typedef struct {
  double young, poisson, radius;                        /* Pa, 1, m */
  double height, exponent, longest, shortest, friction; /* roughness: m, 1, m, m; coefficient */
} idiophone_surface;

typedef struct {
  double latency; /* s */
  double budget;  /* processor time per time of sound; 0: no limit */
  double speed;   /* of the machine, for the budget: idiophone_measured_speed(); 0: 1 */
  uint64_t seed;
  const double* ears;   /* x, y, z of each, m */
  int32_t ear_count;    /* 1 to 4; the channels */
  int32_t rate;         /* audio samples per second */
  int32_t most_strokes; /* that scrape or roll at once */
  int32_t most_proxies; /* that may sound at once; 0: 8 */
  double air_density;   /* around proxies, kg/m3; 0: 1.204 */
  double air_speed;     /* of sound around proxies, m/s; 0: 343 */
} idiophone_options;

typedef struct {
  uint64_t contact;    /* a number that stays the same while the same bodies touch */
  double point[3];     /* in the world, m */
  double normal[3];    /* unit vector: of the force on the first body */
  double slip[3];      /* velocity of the first body over the second along the surface, m/s */
  double impulse;      /* along the normal in this step, N s */
  double roll;         /* speed of the point of contact along the surfaces, m/s */
  double mass;         /* that the impulse moves, kg; 0: from the masses of the bodies */
  double moment;       /* of an impact in the step, 0 to 1; below 0: any */
  int32_t phase;       /* idiophone_phase; the impulse of an end is left out */
  int32_t bodies[2];   /* numbers of the stage, or IDIOPHONE_NOBODY */
  int32_t surfaces[2]; /* numbers of the stage, of both sides */
  int32_t reserved;    /* 0 */
} idiophone_contact;

typedef struct {
  uint64_t sounding, modes, heard; /* bodies with maps; modes of these; those that are heard: with a budget only */
  uint64_t strokes, impacts, left_out;
  double cost;       /* processor time per time of sound, as it is estimated: with a budget only */
  double loss;       /* share of the power that is left out: with a budget only */
  uint64_t proxies;  /* that sound */
  double proxy_cost; /* of these, processor time per time of sound, as it is estimated */
  uint64_t gaps;     /* times when proxies fell silent because idiophone_stage_step() was late */
} idiophone_report;

/* Why the last function that failed in this thread did so; never null. Valid until the next one fails. */
IDIOPHONE_API const char* idiophone_message(void);

/* How fast this machine computes sound maps, relative to the machine on which the costs were measured. Takes some
   0.1 s. */
IDIOPHONE_API idiophone_status idiophone_measured_speed(double* speed);

IDIOPHONE_API idiophone_status idiophone_map_read(const char* file, idiophone_map** map);
IDIOPHONE_API idiophone_status idiophone_map_from_bytes(const void* bytes, uint64_t size, idiophone_map** map);
/* A stage keeps what it needs of its maps. Null is allowed. */
IDIOPHONE_API void idiophone_map_free(idiophone_map* map);

IDIOPHONE_API idiophone_status idiophone_proxy_read(const char* file, idiophone_proxy** proxy);
IDIOPHONE_API idiophone_status idiophone_proxy_from_bytes(const void* bytes, uint64_t size, idiophone_proxy** proxy);
/* As for maps. */
IDIOPHONE_API void idiophone_proxy_free(idiophone_proxy* proxy);

/* The list of bodies may be null if it has none. */
IDIOPHONE_API idiophone_status idiophone_stage_create(const idiophone_options* options,
                                                      const idiophone_map* const* bodies, int32_t body_count,
                                                      const idiophone_surface* surfaces, int32_t surface_count,
                                                      idiophone_stage** stage);
/* Null is allowed. */
IDIOPHONE_API void idiophone_stage_free(idiophone_stage* stage);

/* A body joins; body: its number, the lowest that is free. A body that leaves fades without a click after the next
   step; then its number is free. */
IDIOPHONE_API idiophone_status idiophone_stage_add(idiophone_stage* stage, const idiophone_map* map, int32_t* body);
IDIOPHONE_API idiophone_status idiophone_stage_add_proxy(idiophone_stage* stage, const idiophone_proxy* proxy,
                                                         int32_t* body);
IDIOPHONE_API idiophone_status idiophone_stage_remove(idiophone_stage* stage, int32_t body);

/* position: x, y, z; turn: unit quaternion x, y, z, w */
IDIOPHONE_API idiophone_status idiophone_stage_place(idiophone_stage* stage, int32_t body, const double* position,
                                                     const double* turn);
/* Times the stiffness of the springs (of proxies only), the damping by the material, and the lengths. */
IDIOPHONE_API idiophone_status idiophone_stage_tune(idiophone_stage* stage, int32_t body, double tension,
                                                    double friction, double size);
IDIOPHONE_API idiophone_status idiophone_stage_listen(idiophone_stage* stage, const double* ears, int32_t ear_count);
IDIOPHONE_API idiophone_status idiophone_stage_contact(idiophone_stage* stage, const idiophone_contact* contact);
IDIOPHONE_API idiophone_status idiophone_stage_step(idiophone_stage* stage, double duration);
IDIOPHONE_API idiophone_status idiophone_stage_report(idiophone_stage* stage, idiophone_report* report);

/* For the audio thread: the next samples, [frames x channels]. Takes no lock and no memory, and leaves no message.
   full_scale: pressure that becomes 1, Pa */
IDIOPHONE_API idiophone_status idiophone_stage_render(idiophone_stage* stage, float* sound, uint64_t frames,
                                                      double full_scale);

#ifdef __cplusplus
}
#endif
/* NOLINTEND(modernize-deprecated-headers,modernize-use-using) */
#endif
