/**
 * Script URLs on pages that require Trusted Types (`require-trusted-types-for 'script'`). The policy's name is part of
 * the public interface: a page that lists its policies must include it in `trusted-types`.
 */
const POLICY = 'shapespline';

/** Missing in TypeScript's DOM types. */
interface TrustedTypes {
  createPolicy(
    name: string,
    rules: { createScriptURL(address: string): string },
  ): { createScriptURL(address: string): unknown };
}

let policy: ReturnType<TrustedTypes['createPolicy']> | null | undefined;

/**
 * The URL in the type that the page requires. Unchanged if the page forbids the policy, because the page may not
 * require the type.
 */
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
