/* SPDX-License-Identifier: MIT
 *
 * Whole powers of five that fit into 128 bits. Ten to the power of k is five to the power of k, shifted by k bits.
 */
#ifndef PLB_BASE_NUMBER_POWERS_H
#define PLB_BASE_NUMBER_POWERS_H

#include <stdint.h>

__extension__ typedef unsigned __int128 uint128;

#define MAX_POWER_64 27  /* the last one below 2 to the power of 64 */
#define MAX_POWER_128 55 /* and of 128 */

/* Gives five to the power of k, 0 <= k <= MAX_POWER_64. */
static inline uint64_t power_of_five(int k)
{
    static const uint64_t powers[MAX_POWER_64 + 1] = {
        1u, 5u, 25u, 125u, 625u, 3125u, 15625u, 78125u, 390625u, 1953125u, 9765625u, 48828125u, 244140625u, 1220703125u,
        6103515625u, 30517578125u, 152587890625u, 762939453125u, 3814697265625u, 19073486328125u, 95367431640625u,
        476837158203125u, 2384185791015625u, 11920928955078125u, 59604644775390625u, 298023223876953125u,
        1490116119384765625u, 7450580596923828125u};
    return powers[k];
}

/* The same, 0 <= k <= MAX_POWER_128. */
static inline uint128 wide_power_of_five(int k)
{
    if (k <= MAX_POWER_64)
        return power_of_five(k);
    int more = k - MAX_POWER_64 <= MAX_POWER_64 ? k - MAX_POWER_64 : MAX_POWER_64;
    return (uint128)power_of_five(MAX_POWER_64) * power_of_five(more) * power_of_five(k - MAX_POWER_64 - more);
}

#endif
