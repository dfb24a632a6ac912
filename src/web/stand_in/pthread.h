/* SPDX-License-Identifier: MIT
 *
 * This header stands in for that of POSIX threads where there is one thread: nobody waits for a lock.
 */
#ifndef PLB_WEB_STAND_IN_PTHREAD_H
#define PLB_WEB_STAND_IN_PTHREAD_H

#include <sys/types.h> /* which has the types */

static inline int pthread_mutex_init(pthread_mutex_t *lock, const void *attributes)
{
    (void)lock;
    (void)attributes;
    return 0;
}

static inline int pthread_mutex_lock(pthread_mutex_t *lock)
{
    (void)lock;
    return 0;
}

static inline int pthread_mutex_unlock(pthread_mutex_t *lock)
{
    (void)lock;
    return 0;
}

static inline int pthread_mutex_destroy(pthread_mutex_t *lock)
{
    (void)lock;
    return 0;
}

#endif
