/**
 * Addresses of scripts on pages that require Trusted Types (`require-trusted-types-for 'script'`). The policy's name is
 * part of what the package promises: a page that lists its policies names it in `trusted-types`.
 */
const POLICY = 'shapespline';

/** Of what TypeScript's DOM types do not have yet. */
interface TrustedTypes {
  createPolicy(
    name: string,
    rules: { createScriptURL(address: string): string },
  ): { createScriptURL(address: string): unknown };
}

let policy: ReturnType<TrustedTypes['createPolicy']> | null | undefined;

/** The address as the page takes it; as it is where the page does not let the policy be made, and may not need it. */
export function trustedAddress(address: string): string {
  if (policy === undefined) policy = madePolicy();
  return (policy?.createScriptURL(address) ?? address) as string;
}

function madePolicy(): typeof policy {
  const { trustedTypes } = globalThis as { trustedTypes?: TrustedTypes };
  try {
    return trustedTypes?.createPolicy(POLICY, { createScriptURL: (address) => address }) ?? null;
  } catch {
    return null;
  }
}
