// SPDX-License-Identifier: Apache-2.0
// What plugin/cppNames.ts makes of the C++ sources.
declare module "kelpie:names" {
  const names: {
    enums: Record<string, string[]>;
    numbers: Record<string, number>;
    palette: [number, number, number][];
    motions: { name: string; use: string }[];
  };
  export default names;
}
